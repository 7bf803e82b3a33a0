// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/firmware/byte_ring.h"

bool byte_ring_put(struct byte_ring* ring, const uint8_t* bytes, size_t count) {
    const uint32_t put = ring->put;
    if (count > BYTE_RING_SIZE - (put - ring->taken))
        return false;
    for (size_t i = 0; i < count; ++i)
        ring->bytes[(put + i) % BYTE_RING_SIZE] = bytes[i];
    ring->put = put + (uint32_t)count; // after the bytes, which are volatile, too
    return true;
}

bool byte_ring_take(struct byte_ring* ring, uint8_t* byte) {
    const uint32_t taken = ring->taken;
    if (taken == ring->put)
        return false;
    *byte = ring->bytes[taken % BYTE_RING_SIZE];
    ring->taken = taken + 1;
    return true;
}

bool byte_ring_is_empty(const struct byte_ring* ring) {
    return ring->taken == ring->put;
}
