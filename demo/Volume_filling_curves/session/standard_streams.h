// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_STANDARD_STREAMS_H
#define VFC_STANDARD_STREAMS_H

namespace vfc {

// A caller can close the standard streams, as 2>&- does in a shell. The next file to be opened
// would then take the place of one, and contain the messages, too. Reserves these places; writing
// to them remains an error.
void reserve_standard_streams();

} // namespace vfc

#endif // VFC_STANDARD_STREAMS_H
