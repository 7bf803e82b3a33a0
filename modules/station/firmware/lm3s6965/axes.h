// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CHIRON_FIRMWARE_AXES_H
#define CHIRON_FIRMWARE_AXES_H

// Prepares what this build has for axes: encoders, bridges and converters (axes_hardware.c), or nothing
// (axes_computed.c). The functions of board.h about axes stand in the same file.
void axes_begin(void);

#endif
