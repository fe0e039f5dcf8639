// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PYTHON_ANY_DOMAIN_H
#define VFC_PYTHON_ANY_DOMAIN_H

#include "arrays.h"

#include <CGAL/Volume_filling_curves/internal/domain/Depth_test.h>
#include <CGAL/Volume_filling_curves/internal/domain/Planar_rays.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth_of_segment.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

// Python chooses the kind of a domain at run time. Each template of the library that takes a domain
// in space is compiled once, for a domain that hands all questions on to the one it stands for: a
// filling takes 25 s to compile, and one more indirection is nothing beside a query.

namespace vfc_python {

namespace internal = VFC::internal;

// A domain of any kind, a model of VolumeFillingDomainWithSurface_3. Copies share their data.
class Any_domain
{
public:
  using Point_3 = Point;
  using Vector_3 = Curve::Traits::Vector_3;

  template <typename Domain>
  static Any_domain of(Domain domain)
  {
    Any_domain any;
    any.m_domain = std::make_shared<const Model<Domain>>(std::move(domain));
    return any;
  }

  bool has_surface() const { return m_domain->has_surface(); }
  Any_domain scaled(double factor) const { return m_domain->scaled(factor); }
  CGAL::Bbox_3 bbox() const { return m_domain->bbox(); }
  bool is_inside(const Point& p) const { return m_domain->is_inside(p); }

  bool is_triangle_inside(const Point& p, const Point& q, const Point& r) const
  {
    return m_domain->is_triangle_inside(p, q, r);
  }

  double distance(const Point& p) const { return m_domain->distance(p); }

  double distance_up_to(const Point& p, double limit) const
  {
    return m_domain->distance_up_to(p, limit);
  }

  double distance_along(const Point& p, const Vector_3& direction, double limit) const
  {
    return m_domain->distance_along(p, direction, limit);
  }

  std::pair<double, double> distance_of_segment(const Point& p, const Point& q) const
  {
    return m_domain->distance_of_segment(p, q);
  }

  void shorten(internal::Planar_rays& rays) const { m_domain->shorten(rays); }

  // of domains with a surface
  std::size_t part(const Point& p) const { return m_domain->part(p); }
  const std::vector<CGAL::Bbox_3>& part_boxes() const { return m_domain->part_boxes(); }

private:
  struct Interface
  {
    virtual ~Interface() = default;
    virtual bool has_surface() const = 0;
    virtual Any_domain scaled(double factor) const = 0;
    virtual CGAL::Bbox_3 bbox() const = 0;
    virtual bool is_inside(const Point& p) const = 0;
    virtual bool is_triangle_inside(const Point& p, const Point& q, const Point& r) const = 0;
    virtual double distance(const Point& p) const = 0;
    virtual double distance_up_to(const Point& p, double limit) const = 0;
    virtual double distance_along(const Point& p, const Vector_3& u, double limit) const = 0;
    virtual std::pair<double, double> distance_of_segment(const Point& p, const Point& q) const = 0;
    virtual void shorten(internal::Planar_rays& rays) const = 0;
    virtual std::size_t part(const Point& p) const = 0;
    virtual const std::vector<CGAL::Bbox_3>& part_boxes() const = 0;
  };

  template <typename Domain>
  class Model final : public Interface
  {
    static constexpr bool is_with_surface = internal::Has_surface<Domain>::value;

  public:
    explicit Model(Domain domain) : m_domain(std::move(domain)) {}

    bool has_surface() const override { return is_with_surface; }
    Any_domain scaled(double factor) const override { return of(m_domain.scaled(factor)); }
    CGAL::Bbox_3 bbox() const override { return m_domain.bbox(); }
    bool is_inside(const Point& p) const override { return m_domain.is_inside(p); }

    bool is_triangle_inside(const Point& p, const Point& q, const Point& r) const override
    {
      return m_domain.is_triangle_inside(p, q, r);
    }

    double distance(const Point& p) const override { return m_domain.distance(p); }

    double distance_up_to(const Point& p, double limit) const override
    {
      return internal::depth_up_to(m_domain, p, limit);
    }

    double distance_along(const Point& p, const Vector_3& u, double limit) const override
    {
      return m_domain.distance_along(p, u, limit);
    }

    std::pair<double, double> distance_of_segment(const Point& p, const Point& q) const override
    {
      return internal::depth_of_segment(m_domain, p, q);
    }

    void shorten(internal::Planar_rays& rays) const override
    {
      if constexpr(is_with_surface) return m_domain.shorten(rays);
      const Point p(rays.source.x(), rays.source.y(), rays.source.z());
      const double clear = m_domain.distance(p);
      for(std::size_t l = 0; l < rays.size(); ++l)
        if(rays.lengths[l] > clear)
          rays.lengths[l] = m_domain.distance_along(p, Vector_3(rays.x[l], rays.y[l], rays.z[l]),
                                                    rays.lengths[l]);
    }

    std::size_t part([[maybe_unused]] const Point& p) const override
    {
      if constexpr(is_with_surface) return m_domain.part(p);
      return 0;
    }

    const std::vector<CGAL::Bbox_3>& part_boxes() const override
    {
      if constexpr(is_with_surface) return m_domain.part_boxes();
      static const std::vector<CGAL::Bbox_3> none;
      return none;
    }

  private:
    Domain m_domain;
  };

  std::shared_ptr<const Interface> m_domain;
};

} // namespace vfc_python

#endif // VFC_PYTHON_ANY_DOMAIN_H
