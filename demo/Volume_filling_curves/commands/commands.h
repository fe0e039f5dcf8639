// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COMMANDS_H
#define VFC_COMMANDS_H

namespace vfc {

struct Command_line;

// Each function adds one command; it is defined in the file of the same name.
void add_check_command(Command_line& command_line);
void add_convert_command(Command_line& command_line);
void add_draw_command(Command_line& command_line);
void add_fill_command(Command_line& command_line);
void add_generate_command(Command_line& command_line);
void add_identify_command(Command_line& command_line);
void add_measure_command(Command_line& command_line);
void add_repair_command(Command_line& command_line);
void add_simplify_command(Command_line& command_line);
void add_untangle_command(Command_line& command_line);

} // namespace vfc

#endif // VFC_COMMANDS_H
