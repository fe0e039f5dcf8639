// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_GENERATORS_H
#define CGAL_VOLUME_FILLING_CURVES_GENERATORS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/generators/braid_closure.h>
#include <CGAL/Volume_filling_curves/internal/generators/hard_unknot.h>
#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/generators/random_polygons.h>
#include <CGAL/Volume_filling_curves/internal/generators/torus_knot.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \addtogroup PkgVolumeFillingCurvesGenerators
 *
 * Closed curves for experiments and tests: knots and links of known types, and polygons. The same
 * arguments give the same bits on every machine. The networks are embedded, random polygons with
 * probability 1. The functions can run concurrently and take time near-linear in the number of
 * nodes, `make_hard_unknot()` in the number of moves. `Traits` is a model of `CurveFlowTraits_3`.
 *
 * @{
 */

/*!
 * returns a torus knot T(`p`, `q`), or a link if `p` and `q` have a common divisor, which is then
 * the number of its components.
 *
 * On a torus with radii 2 and 1, the curve runs `p` times around the axis and |`q`| times around
 * the core. Its crossings are positive if `q` is: T(2, 3) is the right-handed trefoil, T(2, -3) the
 * left-handed one, and T(2, 2) the Hopf link.
 *
 * \param p the number of turns around the axis, from 1 to 10,000
 * \param q the number of turns around the core, from -10,000 to 10,000, not 0
 * \param number_of_nodes the number of nodes, which are spaced equally
 * \param random_seed the seed of a random rotation; 0 for none
 * \param traits the traits object
 *
 * \throws std::invalid_argument if `p` or `q` is out of range, or if there are too few nodes for
 * the knot
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_torus_knot(int p,
                                                      int q,
                                                      std::size_t number_of_nodes,
                                                      std::uint64_t random_seed = 0,
                                                      const Traits& traits = Traits())
{
  return internal::closed_network(internal::torus_knot(p, q, number_of_nodes, random_seed), traits);
}

/*!
 * returns the closure of a braid. Every knot and every link is a closed braid
 * \cgalCite{vfc:a-lskc-23}.
 *
 * The strands run side by side around the z-axis, at distance 1. The letter `i` of the word
 * exchanges the strands `i` and `i + 1` by a half turn with a positive crossing, and `-i` with a
 * negative one: the word 1 1 1 is the right-handed trefoil, 1 -2 1 -2 the figure-eight knot, and 1
 * -2 1 -2 1 -2 the Borromean rings.
 *
 * \param word the letters, 1 to 1000 or their negatives; see also `parse_braid_word()`
 * \param number_of_nodes the number of nodes, which are spaced equally
 * \param random_seed the seed of a random rotation; 0 for none
 * \param number_of_strands the least number of strands, at most 10,000; with an empty word, the
 * number of unlinked circles
 * \param traits the traits object
 *
 * \throws std::invalid_argument if a letter or the number of strands is out of range, or if there
 * are too few nodes
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_closed_braid(const std::vector<int>& word,
                                                        std::size_t number_of_nodes,
                                                        std::uint64_t random_seed = 0,
                                                        std::size_t number_of_strands = 1,
                                                        const Traits& traits = Traits())
{
  return internal::closed_network(
      internal::braid_closure(word, number_of_nodes, random_seed, number_of_strands), traits);
}

/*!
 * returns the letters of a braid word, such as "1 -2 1 -2", for `make_closed_braid()`.
 *
 * \param text the letters, separated by spaces
 *
 * \throws std::invalid_argument if a letter is not an integer in 1, ..., 1000 or the negative of
 * one
 */
[[nodiscard]] inline std::vector<int> parse_braid_word(const std::string& text)
{
  return internal::parse_braid_word(text);
}

/*!
 * returns an unknot in disguise: a circle in the unit ball after random moves of its nodes, each
 * certified by `Isotopy_guard_3`.
 *
 * \param number_of_nodes the number of nodes, at least 3
 * \param number_of_moves the number of attempted moves; 10 per node make a tangle. It is rounded
 * down to a multiple of the number of scales, which is 1 up to 32 nodes and grows by 1 with each
 * doubling
 * \param random_seed the seed of the moves
 * \param traits the traits object
 *
 * \throws std::invalid_argument if there are fewer than 3 nodes
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_hard_unknot(std::size_t number_of_nodes,
                                                       std::size_t number_of_moves,
                                                       std::uint64_t random_seed = 0,
                                                       const Traits& traits = Traits())
{
  return internal::closed_network(
      internal::hard_unknot(number_of_nodes, number_of_moves, random_seed), traits);
}

/*!
 * returns a random closed polygon with edges of length 1 (the hedgehog method
 * \cgalCite{vfc:kvadf-eevtp-88}).
 *
 * It is embedded with probability 1, and mostly knotted if it has several hundred nodes.
 *
 * \param number_of_nodes the number of nodes, at least 3
 * \param random_seed the seed of the polygon
 * \param traits the traits object
 *
 * \throws std::invalid_argument if there are fewer than 3 nodes
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_random_polygon(std::size_t number_of_nodes,
                                                          std::uint64_t random_seed = 0,
                                                          const Traits& traits = Traits())
{
  return internal::closed_network(internal::random_polygon(number_of_nodes, random_seed), traits);
}

/*!
 * returns a random polygon on the cubic lattice, an unknot: a unit square after random edges were
 * pushed sideways by one unit. Many of its edges are parallel, collinear or coplanar.
 *
 * \param number_of_nodes the number of nodes, even and at least 4
 * \param random_seed the seed of the polygon
 * \param traits the traits object
 *
 * \throws std::invalid_argument if the number of nodes is odd or less than 4
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_lattice_polygon(std::size_t number_of_nodes,
                                                           std::uint64_t random_seed = 0,
                                                           const Traits& traits = Traits())
{
  return internal::closed_network(internal::lattice_polygon(number_of_nodes, random_seed), traits);
}

/*!
 * returns a regular polygon, counterclockwise in the plane z = 0 around the origin: a circle if it
 * has many nodes.
 *
 * \param number_of_nodes the number of nodes, at least 3
 * \param radius the distance of the nodes from the origin
 * \param traits the traits object
 *
 * \throws std::invalid_argument if there are fewer than 3 nodes, or if the radius is not between
 * 1e-150 and 1e150
 */
template <typename Traits = Curve_flow_traits_3<>>
[[nodiscard]] Curve_network_3<Traits> make_regular_polygon(std::size_t number_of_nodes,
                                                           double radius = 1,
                                                           const Traits& traits = Traits())
{
  return internal::closed_network({internal::regular_polygon(number_of_nodes, radius)}, traits);
}

/// @}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_GENERATORS_H
