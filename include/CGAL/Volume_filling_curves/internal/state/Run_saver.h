// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>
#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/curve/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/coordinate_range.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/state/State_archive.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/version.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Fingerprint of a run: lines with the version, the kind of run, all parameters except those that
// end a run, and hashes of curves and domain. A run resumes only if all lines match.

template <typename Value, typename = void>
constexpr bool is_printable = false;

template <typename Value>
constexpr bool
    is_printable<Value,
                 std::void_t<decltype(std::declval<std::ostream&>() << std::declval<Value>())>> =
        !std::is_pointer_v<Value>;

template <typename Parameters, typename Row>
void print_row(std::ostream& out, const Parameters& p, const Row& row)
{
  using namespace internal_np;
  using Tag = typename Row::Tag;
  using Value = std::decay_t<decltype(p.*row.member)>;
  constexpr bool is_limit = std::is_same_v<Tag, number_of_iterations_t> ||
                            std::is_same_v<Tag, time_limit_t> || std::is_same_v<Tag, progress_t> ||
                            std::is_same_v<Tag, checkpoint_t> || std::is_same_v<Tag, resume_from_t>;
  if constexpr(!is_limit) {
    out << name_of(Tag()) << ' ';
    if constexpr(is_printable<Value>)
      out << p.*row.member;
    else if constexpr(std::is_enum_v<Value>)
      out << static_cast<int>(p.*row.member);
    else if constexpr(std::is_same_v<Tag, ports_t>)
      out << (p.*row.member).size(); // the curve starts from them
    else                             // a pointer or a function
      out << (p.*row.member ? "given" : "none");
    out << '\n';
  }
}

inline std::string hash_line(const std::string& name, const State_archive& content)
{
  return name + ' ' + to_hex(sha256(content.bytes())) + '\n';
}

template <typename Parameters>
std::string run_fingerprint(const std::string& job, const Parameters& p)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "version " << CGAL_VOLUME_FILLING_CURVES_VERSION << "\njob " << job << '\n';
  std::apply([&](const auto&... row) { (print_row(out, p, row), ...); },
             parameter_table<Parameters>());
  return out.str();
}

// Throws Run_state_error with the first line that differs.
inline void check_fingerprint(const std::string& of_state, const std::string& of_run)
{
  if(of_state == of_run) return;
  std::istringstream state(of_state), run(of_run);
  std::string former, line;
  while(std::getline(state, former) && std::getline(run, line) && former == line) {
  }
  const std::size_t end = line.find(' ');
  std::string complaint = "the state is that of a run with another " + line.substr(0, end);
  if(line.size() < end + 64 && former.size() > end) // no hash
    complaint += ":" + former.substr(end) + ", not" + line.substr(end);
  throw Run_state_error(complaint);
}

// Returns the fingerprint of an Any_domain_3: a hash of all corners of a mesh, and of the answers
// to some random queries, by which other domains are recognized.
template <typename Domain, typename Traits>
std::string domain_line(const Domain& domain, const Traits& traits)
{
  constexpr std::size_t number_of_queries = 1000;
  State_archive archive;
  archive(std::vector(domain.corners()));
  auto box = domain.bbox();
  archive(box);
  Random_source random(0);
  for(std::size_t k = 0; k < number_of_queries; ++k) {
    const double x = random.real(), y = random.real(), z = random.real();
    const auto p = to_point(Vector(box.xmin() + x * box.x_span(), box.ymin() + y * box.y_span(),
                                   box.zmin() + z * box.z_span()),
                            traits);
    archive(domain.is_inside(p) ? double(domain.distance(p)) : -1.);
  }
  return hash_line("domain", archive);
}

// Copies a curve without garbage. Reading replaces a curve with the same input.
template <typename Network>
void copy_curve(State_archive& archive, Network& curve)
{
  using Editor = Network_editor<Network>;
  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::size_t> origins, constrained;
  std::vector<Node_constraint> constraints;
  auto labels = Editor::labels(curve);
  for(const std::size_t v : curve.nodes()) {
    points.push_back(to_vector(curve.point(v)));
    origins.push_back(curve.origin(v));
    if(curve.is_free(v)) continue;
    constrained.push_back(v);
    constraints.push_back(curve.constraint(v));
  }
  for(const std::size_t e : curve.edges()) edges.push_back({curve.source(e), curve.target(e)});
  archive(points, edges, origins, constrained, constraints, labels);
  if(!archive.is_reading()) return;
  archive.require(points.size() == origins.size());
  for(const Vector& p : points) archive.require(is_in_range(p));
  Editor(curve).replace(to_points(points, curve.traits()), edges, origins, labels);
  archive.require(constrained.size() == constraints.size());
  for(std::size_t k = 0; k < constrained.size(); ++k) {
    archive.require(constrained[k] < points.size());
    curve.set_constraint(constrained[k], constraints[k]);
  }
}

// Copies everything of a guard but its curve. \pre it records if the guard that was written did
template <typename Guard>
void copy_guard(State_archive& archive, Guard& guard)
{
  double clearance = guard.clearance();
  archive(clearance, guard.counts());
  archive.require(clearance >= 0);
  guard.set_clearance(clearance);
  auto* const record = guard.record();
  if(!record) return;
  archive(record->contents());
  archive.require(record->numbers().size() == guard.curve().number_of_nodes());
}

// The parts that a run depends on, from the outer ones to the inner ones: the order in which they
// are written, and read by a run that resumes.
class Run_saver
{
  using Copy = std::function<void(State_archive&)>;

public:
  // A part, as long as it exists.
  class Kept
  {
  public:
    explicit Kept(std::vector<Copy>& parts) : m_parts(parts) {}
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;
    ~Kept() { m_parts.pop_back(); }

  private:
    std::vector<Copy>& m_parts;
  };

  // Takes a function that returns the fingerprint, which can take long, and is not always needed.
  // Throws Run_state_error if there is a state to resume from that is of another run.
  template <typename Fingerprint>
  Run_saver(const Curve_run_parameters& parameters, const Fingerprint& fingerprint)
      : m_checkpoint(parameters.checkpoint)
  {
    const Run_state* const former = parameters.resume_from;
    const bool is_resuming = former && !former->is_empty();
    if(is_saving() || is_resuming) m_fingerprint = fingerprint();
    if(!is_resuming) return;
    m_former = State_archive(former->body());
    std::string of_former;
    m_former(of_former);
    check_fingerprint(of_former, m_fingerprint);
  }

  bool is_saving() const { return static_cast<bool>(m_checkpoint); }

  // whether a part is to be read that has not been kept yet
  bool is_resuming() const { return !m_former.is_at_end(); }

  // Keeps a part, which the function copies; if the run resumes, to it at once.
  [[nodiscard]] Kept keep(const Copy& copy)
  {
    if(is_resuming()) copy(m_former);
    m_parts.push_back(copy);
    return Kept(m_parts);
  }

  // Keeps a curve. A curve that is read is checked by a function that throws std::invalid_argument:
  // subsequent certificates require an embedded curve.
  template <typename Network, typename Check>
  [[nodiscard]] Kept keep_curve(Network& curve, const Check& check)
  {
    return keep([&curve, check](State_archive& archive) {
      if(!archive.is_reading()) return copy_curve(archive, curve);
      Network read = curve;
      try {
        copy_curve(archive, read);
        check_embedded(read);
        check(read);
      } catch(const std::invalid_argument& error) {
        throw Run_state_error(std::string("the curve of the state: ") + error.what());
      }
      curve = std::move(read);
    });
  }

  template <typename Guard>
  [[nodiscard]] Kept keep_guard(Guard& guard)
  {
    return keep([&guard](State_archive& archive) { copy_guard(archive, guard); });
  }

  Run_state state() const
  {
    State_archive archive;
    archive(std::string(m_fingerprint));
    for(const Copy& copy : m_parts) copy(archive);
    return Run_state::sealed(archive.bytes());
  }

  Run_state state_if_saving() const { return is_saving() ? state() : Run_state(); }

  // Offers the state of a run that continues or ends early.
  void offer(bool is_last) const
  {
    if(is_saving()) m_checkpoint({[this] { return state(); }, is_last});
  }

  // Offers a former state to a run that ends early.
  void offer_last(const Run_state& state) const
  {
    if(is_saving()) m_checkpoint({[&state] { return state; }, true});
  }

private:
  const std::function<void(const Run_checkpoint&)>& m_checkpoint; // none if nothing is saved
  std::string m_fingerprint;
  State_archive m_former{std::string_view()}; // to resume from
  std::vector<Copy> m_parts;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_RUN_SAVER_H
