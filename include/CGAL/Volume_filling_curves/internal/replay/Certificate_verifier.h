// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_VERIFIER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_VERIFIER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Canonical_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Certificate_reader.h>
#include <CGAL/Volume_filling_curves/internal/replay/Certificate_replay.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Verifier of certificates: compares the curves at both ends with the given ones, and replays the
// operations in between. It stops at the first fault.
class Certificate_verifier
{
  using Kind = Certificate_operation::Kind;

public:
  // With an enclosure the curve must not leave it. The replay is under a watch, if there is one.
  explicit Certificate_verifier(std::string_view bytes,
                                const Enclosure* enclosure = nullptr,
                                Run_watch* watch = nullptr)
      : m_reader(bytes), m_enclosure(enclosure), m_watch(watch)
  {}

  // returns whether the certificate leads from one curve to the other. \throws Run_stopped
  bool operator()(const Canonical_curve& start, const Canonical_curve& end)
  {
    try {
      check_start(start);
      Certificate_replay replay(start.points(), start.edges(), m_enclosure, m_watch);
      replay.require_embedded();
      replay.require_inside();
      run(replay);
      check_end(Canonical_curve(replay.curve()), end);
    } catch(const Certificate_format_error& error) {
      m_message = error.what();
    } catch(const Refusal& refusal) {
      m_message = m_subject + refusal.what();
    }
    return m_message.empty();
  }

  const std::string& message() const { return m_message; }

  // counted from 1; 0 if it is none of them
  std::size_t wrong_operation() const { return m_message.empty() ? 0 : m_current; }

  std::size_t number_of_operations() const { return m_number_of_operations; }

private:
  static void require(bool condition, const char* what)
  {
    if(!condition) throw Refusal(what);
  }

  void check_start(const Canonical_curve& start)
  {
    const Certificate_header header = m_reader.header();
    m_subject = "start: ";
    require(header.curve == start.digest(), "the certificate starts from another curve");
    require(header.nodes == start.points().size() && header.edges == start.edges().size() &&
                header.components == start.number_of_components(),
            "the numbers of nodes, edges and components at the start are wrong");
  }

  void run(Certificate_replay& replay)
  {
    for(;;) {
      check(m_watch);
      m_current = m_number_of_operations + 1;
      const Certificate_operation operation = m_reader.operation();
      if(operation.kind == Kind::END) break;
      m_subject = description(operation) + ": ";
      replay(operation);
      ++m_number_of_operations;
    }
    m_current = 0;
  }

  void check_end(const Canonical_curve& replayed, const Canonical_curve& end)
  {
    m_subject = "end: ";
    const Certificate_trailer trailer = m_reader.trailer();
    require(trailer.operations == m_number_of_operations, "the number of operations is wrong");
    require(trailer.nodes == replayed.points().size() && trailer.edges == replayed.edges().size(),
            "the numbers of nodes and edges at the end are wrong");
    require(trailer.curve == replayed.digest(), "the record does not lead where it says");
    require(trailer.curve == end.digest(), "the certificate leads to another curve");
    require(trailer.record == sha256(m_reader.record()), "the record has been altered");
  }

  static std::string description(const Certificate_operation& operation)
  {
    switch(operation.kind) {
    case Kind::MOVE:
      return "moving node " + std::to_string(operation.node);
    case Kind::INSERT:
      return "inserting a node between " + std::to_string(operation.node) + " and " +
             std::to_string(operation.other);
    case Kind::REMOVE:
      return "removing node " + std::to_string(operation.node);
    case Kind::END:
      break;
    }
    return "end";
  }

  Certificate_reader m_reader;
  const Enclosure* m_enclosure; // null for none
  Run_watch* m_watch;           // likewise
  std::string m_subject, m_message;
  std::size_t m_current = 0, m_number_of_operations = 0;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_VERIFIER_H
