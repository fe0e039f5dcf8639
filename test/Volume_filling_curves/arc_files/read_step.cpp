// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// A reader of STEP files by OpenCASCADE, for test_arc_files.cpp: `read_step FILE` prints how many
// circles and lines there are, their length, the least radius, and the widest gap between
// consecutive ones, in millimeters.

#include <BRepAdaptor_Curve.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cstdio>
#include <limits>

int main(int argc, char** argv)
{
  STEPControl_Reader reader;
  if(argc != 2 || reader.ReadFile(argv[1]) != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  int circles = 0, lines = 0;
  double length = 0, radius = std::numeric_limits<double>::infinity(), gap = 0;
  gp_Pnt last;
  for(TopExp_Explorer edge(reader.OneShape(), TopAbs_EDGE); edge.More(); edge.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
    const bool is_circle = curve.GetType() == GeomAbs_Circle;
    if(circles + lines > 0) gap = std::max(gap, last.Distance(curve.Value(curve.FirstParameter())));
    last = curve.Value(curve.LastParameter());
    ++(is_circle ? circles : lines);
    if(is_circle) radius = std::min(radius, curve.Circle().Radius());
    length += GCPnts_AbscissaPoint::Length(curve);
  }
  std::printf("%d %d %.15g %.15g %.15g\n", circles, lines, length, radius, gap);
}
