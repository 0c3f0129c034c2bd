// SPDX-License-Identifier: LGPL-2.1-or-later
// A library that is called as Open CASCADE's innermost one is, of another version.

extern "C" int other_kernel() { return 9; }
