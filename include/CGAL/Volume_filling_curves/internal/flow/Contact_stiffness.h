// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CONTACT_STIFFNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CONTACT_STIFFNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Stiffness of contacts between strands that touch the same medial sphere, as a part of the
// preconditioner. The paper's preconditioner couples their nodes weakly and equally in all
// directions. Without the stiffness, contacts oscillate unless steps are short, even along slow
// motions such as that of a loop around a bundle.
//
// A node's sphere with the center x_l, in units of its radius R, touches another node at distance d
// in the direction u, hence R = d / (2 x_l . u). If the other node moves along u, the force alpha w
// R x_l / N on the node changes by alpha w / (2 N) times the motion, along u, whatever the angle
// between u and x_l. Half of this counts for each of the two nodes, which makes the matrix
// symmetric: k u u^T per contact. If the other node is pinned, all of it counts for the first.
class Contact_stiffness
{
public:
  // No contacts.
  Contact_stiffness() = default;

  // Takes the positions and weights of the nodes, the thickness at each, and alpha in units of
  // 1 / r^2. Linear in the number of spheres.
  template <typename Network>
  Contact_stiffness(const Network& curve,
                    const Vector_field& x,
                    const std::vector<double>& weights,
                    const std::vector<double>& thickness,
                    const Medial_spheres& spheres,
                    double medial_weight)
  {
    const auto n = static_cast<double>(spheres.number_of_directions());
    for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
      const Node_circle& circle = spheres.circles()[c];
      if(curve.is_pinned(circle.node)) continue;
      const double r = thickness[circle.node];
      const double alpha = medial_weight / (r * r), weight = weights[circle.node] * circle.share;
      add_contacts(curve, x, spheres, c, alpha * weight / (4 * n));
    }
  }

  bool has_contacts() const { return !m_contacts.empty(); }

  // Adds the stiffness k of each node's contacts, times a factor, to a diagonal.
  void add_to_diagonal(Eigen::VectorXd& diagonal, double factor) const
  {
    for(const Contact& contact : m_contacts) {
      diagonal[contact.first] += factor * contact.stiffness;
      if(contact.is_second_free) diagonal[contact.second] += factor * contact.stiffness;
    }
  }

  // Adds the product of the matrix and a field that is zero at pinned nodes to the image, and
  // returns the product of the field with the addend.
  double add_product(const Vector_field& field, Vector_field& image) const
  {
    double sum = 0;
    for(const Contact& contact : m_contacts) {
      const Vector motion = row(field, contact.first) - row(field, contact.second);
      const double approach = motion.dot(contact.normal);
      const Vector force = contact.stiffness * approach * contact.normal;
      sum += contact.stiffness * approach * approach;
      set_row(image, contact.first, row(image, contact.first) + force);
      if(!contact.is_second_free) continue;
      set_row(image, contact.second, row(image, contact.second) - force);
    }
    return sum;
  }

private:
  using Index = Medial_spheres::Index;

  struct Contact
  {
    Index first, second; // the first one is free
    bool is_second_free; // not pinned
    Vector normal;
    double stiffness;
  };

  // Adds the contacts of a circle's node; neighboring spheres that touch the same node make one.
  template <typename Network>
  void add_contacts(const Network& curve,
                    const Vector_field& x,
                    const Medial_spheres& spheres,
                    std::size_t c,
                    double stiffness)
  {
    const auto node = static_cast<Index>(spheres.circles()[c].node);
    Index last = Medial_spheres::no_node;
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const Index other = spheres.touching_node(c, l);
      const bool is_new = std::exchange(last, other) != other;
      if(other == Medial_spheres::no_node) continue;
      const bool is_free = !curve.is_pinned(other);
      if(is_new)
        m_contacts.push_back(
            {node, other, is_free, (row(x, other) - row(x, node)).normalized(), 0});
      m_contacts.back().stiffness += is_free ? stiffness : 2 * stiffness;
    }
  }

  std::vector<Contact> m_contacts;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_CONTACT_STIFFNESS_H
