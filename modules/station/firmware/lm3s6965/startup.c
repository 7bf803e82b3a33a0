// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors, memory at reset, and the two functions that the compiler may call.
#include <stddef.h>
#include <stdint.h>

extern uint32_t linker_data_from, linker_data, linker_data_end, linker_bss, linker_bss_end, linker_stack;

int main(void);
void reset_handler(void);
void stop_handler(void);
void systick_handler(void);
void uart0_handler(void);
void uart1_handler(void);
void* memcpy(void* restrict to, const void* restrict from, size_t count);
void* memset(void* to, int value, size_t count);

void* memcpy(void* restrict to, const void* restrict from, size_t count) {
    uint8_t* at = to;
    const uint8_t* source = from;
    while (count-- > 0)
        *at++ = *source++;
    return to;
}

void* memset(void* to, int value, size_t count) {
    uint8_t* at = to;
    while (count-- > 0)
        *at++ = (uint8_t)value;
    return to;
}

void reset_handler(void) {
    const uint32_t* from = &linker_data_from;
    for (uint32_t* to = &linker_data; to < &linker_data_end;)
        *to++ = *from++;
    for (uint32_t* to = &linker_bss; to < &linker_bss_end;)
        *to++ = 0;
    (void)main();
    stop_handler();
}

// A fault of the processor, or an interrupt that nobody expects: nothing feeds the watchdog, which resets and
// opens the bridges.
void stop_handler(void) {
    for (;;) {
    }
}

typedef void (*vector)(void);

struct vectors {
    uint32_t* stack;
    vector handlers[15 + 7];
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    &linker_stack,
    {
        reset_handler,
        stop_handler, // not maskable
        stop_handler, // hard fault
        stop_handler, // memory
        stop_handler, // bus
        stop_handler, // usage
        0,
        0,
        0,
        0,
        stop_handler, // supervisor call
        stop_handler, // debug
        0,
        stop_handler, // pending service
        systick_handler,
        stop_handler, // ports A to E
        stop_handler,
        stop_handler,
        stop_handler,
        stop_handler,
        uart0_handler,
        uart1_handler,
    }};
