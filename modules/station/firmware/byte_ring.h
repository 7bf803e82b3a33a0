// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes from one context to another, as from an interrupt to the program: one puts, one takes.
#ifndef CHIRON_FIRMWARE_BYTE_RING_H
#define CHIRON_FIRMWARE_BYTE_RING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define BYTE_RING_SIZE 2048u // a power of two

struct byte_ring {
    volatile uint32_t put;   // counts bytes; of the one that puts
    volatile uint32_t taken; // of the one that takes
    volatile uint8_t bytes[BYTE_RING_SIZE];
};

// All of them, or none where there is no room.
bool byte_ring_put(struct byte_ring* ring, const uint8_t* bytes, size_t count);
bool byte_ring_take(struct byte_ring* ring, uint8_t* byte);
bool byte_ring_is_empty(const struct byte_ring* ring);

#ifdef __cplusplus
}
#endif
#endif
