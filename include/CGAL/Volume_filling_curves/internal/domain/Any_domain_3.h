// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_ANY_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_ANY_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/triangle_distance.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Domain of any kind, which hands each question on to the domain that it stands for. fill() and
// untangle() thus compile once for all domains of a dimension. The answers are the same, hence the
// bits of the curves too; a virtual call costs nothing beside a query. Copies share the domain.
template <typename Point_3_, int dimension_ = 3>
class Any_domain_3
{
public:
  using Point_3 = Point_3_;
  using Vector_3 = Vector;

  static constexpr int dimension = dimension_;

  // a domain that is owned
  template <typename Domain>
  static Any_domain_3 of(Domain domain)
  {
    return Any_domain_3(std::make_shared<const Model<Domain>>(std::move(domain)));
  }

  // a domain that must outlive it
  template <typename Domain>
  static Any_domain_3 view_of(const Domain& domain)
  {
    return Any_domain_3(std::make_shared<const Model<const Domain&>>(domain));
  }

  bool has_surface() const { return m_domain->has_surface(); }
  Any_domain_3 scaled(double factor) const { return m_domain->scaled(factor); }
  CGAL::Bbox_3 bbox() const { return m_domain->bbox(); }
  bool is_inside(const Point_3& p) const { return m_domain->is_inside(p); }

  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return m_domain->is_triangle_inside(p, q, r);
  }

  double distance(const Point_3& p) const { return m_domain->distance(p); }

  double distance_up_to(const Point_3& p, double limit) const
  {
    return m_domain->distance_up_to(p, limit);
  }

  double distance_along(const Point_3& p, const Vector& direction, double limit) const
  {
    return m_domain->distance_along(p, direction, limit);
  }

  std::pair<double, double> distance_of_segment(const Point_3& p, const Point_3& q) const
  {
    return m_domain->distance_of_segment(p, q);
  }

  // the corners of the faces of a mesh, none of any other domain
  const std::vector<Corners>& corners() const { return m_domain->corners(); }

  // of domains with a surface
  void shorten(Planar_rays& rays) const { m_domain->shorten(rays); }
  std::size_t part(const Point_3& p) const { return m_domain->part(p); }
  const std::vector<CGAL::Bbox_3>& part_boxes() const { return m_domain->part_boxes(); }

private:
  struct Interface
  {
    virtual ~Interface() = default;
    virtual bool has_surface() const = 0;
    virtual Any_domain_3 scaled(double factor) const = 0;
    virtual CGAL::Bbox_3 bbox() const = 0;
    virtual bool is_inside(const Point_3& p) const = 0;
    virtual bool is_triangle_inside(const Point_3&, const Point_3&, const Point_3&) const = 0;
    virtual double distance(const Point_3& p) const = 0;
    virtual double distance_up_to(const Point_3& p, double limit) const = 0;
    virtual double distance_along(const Point_3& p, const Vector& u, double limit) const = 0;
    virtual std::pair<double, double> distance_of_segment(const Point_3&, const Point_3&) const = 0;
    virtual const std::vector<Corners>& corners() const = 0;
    virtual void shorten(Planar_rays& rays) const = 0;
    virtual std::size_t part(const Point_3& p) const = 0;
    virtual const std::vector<CGAL::Bbox_3>& part_boxes() const = 0;
  };

  // Takes the type of a domain, or of a reference to one.
  template <typename Held>
  class Model final : public Interface
  {
    using Domain = std::decay_t<Held>;
    static constexpr bool is_with_surface = Has_surface<Domain>::value;

  public:
    explicit Model(Held&& domain) : m_domain(std::forward<Held>(domain)) {}

    bool has_surface() const override { return internal::has_surface(m_domain); }

    Any_domain_3 scaled([[maybe_unused]] double factor) const override
    {
      if constexpr(Is_scalable<Domain>::value)
        return of(m_domain.scaled(factor));
      else
        throw std::logic_error("the domain has no member function scaled()");
    }

    CGAL::Bbox_3 bbox() const override { return m_domain.bbox(); }
    bool is_inside(const Point_3& p) const override { return m_domain.is_inside(p); }

    bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const override
    {
      return m_domain.is_triangle_inside(p, q, r);
    }

    double distance(const Point_3& p) const override { return m_domain.distance(p); }

    double distance_up_to(const Point_3& p, double limit) const override
    {
      return depth_up_to(m_domain, p, limit);
    }

    double distance_along(const Point_3& p, const Vector& u, double limit) const override
    {
      return m_domain.distance_along(p, typename Domain::Vector_3(u.x(), u.y(), u.z()), limit);
    }

    std::pair<double, double> distance_of_segment(const Point_3& p, const Point_3& q) const override
    {
      return depth_of_segment(m_domain, p, q);
    }

    const std::vector<Corners>& corners() const override
    {
      static const std::vector<Corners> none;
      if constexpr(Has_corners<Domain>::value)
        return m_domain.corners();
      else
        return none;
    }

    void shorten([[maybe_unused]] Planar_rays& rays) const override
    {
      if constexpr(is_with_surface) m_domain.shorten(rays);
    }

    std::size_t part([[maybe_unused]] const Point_3& p) const override
    {
      if constexpr(is_with_surface)
        return m_domain.part(p);
      else
        return 0;
    }

    const std::vector<CGAL::Bbox_3>& part_boxes() const override
    {
      static const std::vector<CGAL::Bbox_3> none;
      if constexpr(is_with_surface)
        return m_domain.part_boxes();
      else
        return none;
    }

  private:
    Held m_domain;
  };

  explicit Any_domain_3(std::shared_ptr<const Interface> domain) : m_domain(std::move(domain)) {}

  std::shared_ptr<const Interface> m_domain;
};

// Returns a view of a domain, which must outlive it. The whole space, and a domain that is of any
// kind already, stay what they are.
template <typename Domain>
auto any_domain(const Domain& domain)
{
  return Any_domain_3<typename Domain::Point_3, dimension_of<Domain>>::view_of(domain);
}

template <typename Point_3, int dimension>
const Any_domain_3<Point_3, dimension>& any_domain(const Any_domain_3<Point_3, dimension>& domain)
{
  return domain;
}

template <typename Traits>
const Unbounded_domain_3<Traits>& any_domain(const Unbounded_domain_3<Traits>& domain)
{
  return domain;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_ANY_DOMAIN_3_H
