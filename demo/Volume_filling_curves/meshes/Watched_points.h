// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_WATCHED_POINTS_H
#define VFC_WATCHED_POINTS_H

#include "files/mesh_files.h"
#include "session/Work_watch.h"

#include <boost/property_map/property_map.hpp>

namespace vfc {

// Point map of a mesh that can end CGAL's functions, which access points all the time: at the
// request of the watch, an access throws Work_stopped. The object that the function was changing
// must then be discarded.
class Watched_points
{
public:
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;

  Watched_points() = default; // CGAL wants one
  Watched_points(const Mesh& mesh, Work_watch& watch) : m_points(mesh.points()), m_watch(&watch) {}

  friend reference get(const Watched_points& map, key_type v)
  {
    map.poll();
    return map.m_points[v];
  }

  friend void put(const Watched_points& map, key_type v, const value_type& point)
  {
    map.m_points[v] = point;
  }

private:
  // Reading the clock takes as long as several accesses. CGAL copies property maps; the copies
  // share a counter.
  void poll() const
  {
    static thread_local unsigned accesses = 0;
    if(++accesses % 64 == 0) m_watch->check();
  }

  Mesh::Property_map<Mesh::Vertex_index, value_type> m_points;
  Work_watch* m_watch = nullptr;
};

} // namespace vfc

#endif // VFC_WATCHED_POINTS_H
