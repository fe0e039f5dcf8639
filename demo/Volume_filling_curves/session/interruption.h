// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_INTERRUPTION_H
#define VFC_INTERRUPTION_H

#include <string>

namespace CGAL {
namespace Volume_filling_curves {
struct Run_progress;
}
} // namespace CGAL

namespace vfc {

// A file that becomes larger than the system allows is an error like a full disk (SIGXFSZ would end
// the program and leave a part of the file). SIGINT and SIGTERM end the program at once, with the
// status for interruptions, until the first poll: reading has nothing worth saving.
// From then on the first signal is a request to finish and save the result, and the second one ends
// the program at once. A first signal also waits until a file is complete, see Complete_file.

void handle_signals();
void poll_interruptions();
void ignore_polls(); // for those who lose nothing that is complete when they end at once
bool is_interruption_requested();

// While it exists, a first signal waits: a file that is being written, or tried out, would be left
// under a temporary name. Afterwards the program ends or, after the first poll, finishes and saves
// the result.
class Complete_file
{
public:
  Complete_file();
  ~Complete_file();

  Complete_file(const Complete_file&) = delete;
  Complete_file& operator=(const Complete_file&) = delete;
};

// Returns whether a run of the library continues, for its parameter `progress`.
bool is_to_go_on(const CGAL::Volume_filling_curves::Run_progress& progress);

// Output of a program that is ended at once: a line on standard error, and a report. A report is
// written to "-", which is standard output, to a file, or not at all if that is empty, or if the
// file is to be new and is not.
void prepare_last_words(const std::string& line,
                        const std::string& report_file,
                        const std::string& report,
                        bool is_new_file);

// Leaves nothing from here on: the report has been written.
void forget_last_words();

} // namespace vfc

#endif // VFC_INTERRUPTION_H
