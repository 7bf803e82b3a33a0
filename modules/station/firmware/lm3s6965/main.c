// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware on an LM3S6965: 50 MHz, the line on UART0 at 1 Mbit/s, the service line on UART1 at 115,200
// bit/s, SysTick as the timer.
#include "station/firmware/firmware.h"
#include "station/firmware/lm3s6965/axes.h"
#include "station/firmware/lm3s6965/registers.h"

#define CLOCK_HZ 50000000u
#define UART0_INTERRUPT 5u
#define UART1_INTERRUPT 6u

void systick_handler(void);
void uart0_handler(void);
void uart1_handler(void);
int main(void);

static struct firmware firmware;

void board_lock(void) {
    __asm volatile("cpsid i" ::: "memory");
}

void board_unlock(void) {
    __asm volatile("cpsie i" ::: "memory");
}

// As much as the line takes now.
static void send_some(uint32_t uart, struct byte_ring* ring) {
    uint8_t byte = 0;
    while (!(UART_FLAGS(uart) & UART_FLAG_SEND_FULL) && byte_ring_take(ring, &byte))
        UART_DATA(uart) = byte;
}

// The line's interrupts wait while this one runs.
void systick_handler(void) {
    firmware_tick(&firmware);
    send_some(UART0, &firmware.to_send);
    send_some(UART1, &firmware.service);
}

void uart0_handler(void) {
    UART_CLEAR(UART0) = UART_INT_RECEIVED | UART_INT_RECEIVED_LAST | UART_INT_SENT;
    while (!(UART_FLAGS(UART0) & UART_FLAG_RECEIVED_NONE)) {
        const uint8_t byte = (uint8_t)UART_DATA(UART0);
        (void)byte_ring_put(&firmware.received, &byte,
                            1); // without room: the frame is broken, and counted so
    }
    board_lock(); // the tick sends, too
    send_some(UART0, &firmware.to_send);
    board_unlock();
}

void uart1_handler(void) {
    UART_CLEAR(UART1) = UART_INT_SENT;
    board_lock();
    send_some(UART1, &firmware.service);
    board_unlock();
}

static void begin_clock(void) {
    const uint32_t bypass = 1u << 11, divide = 1u << 22, off = 1u << 13;
    uint32_t rcc = SYSTEM_RCC;
    rcc = (rcc | bypass) & ~divide;
    SYSTEM_RCC = rcc;
    rcc =
        (rcc & ~((0xFu << 6) | (3u << 4) | off | 1u)) | (0xEu << 6); // crystal of 8 MHz, main oscillator, PLL
    SYSTEM_RCC = rcc;
    rcc = (rcc & ~(0xFu << 23)) | (3u << 23) | divide; // 200 MHz / 4
    SYSTEM_RCC = rcc;
    while (!(SYSTEM_RIS & (1u << 6))) { // until the PLL is locked
    }
    SYSTEM_RCC = rcc & ~bypass;
}

static void begin_line(uint32_t uart, uint32_t baud, uint32_t mask) {
    const uint32_t divisor = (CLOCK_HZ * 4u + baud / 2u) / baud; // in 64ths of 16 clocks
    UART_CONTROL(uart) = 0;
    UART_WHOLE_DIVISOR(uart) = divisor / 64u;
    UART_PART_DIVISOR(uart) = divisor % 64u;
    UART_LINE(uart) = 0x70u;   // 8N1, with buffers
    UART_LEVELS(uart) = 0x08u; // 4 received, 2 left to send
    UART_MASK(uart) = mask;
    UART_CONTROL(uart) = 0x301u;
}

static void begin_lines(void) {
    SYSTEM_RCGC1 |= 3u;
    SYSTEM_RCGC2 |= (1u << 0) | (1u << 3);
    (void)SYSTEM_RCGC2;
    PORT_ALTERNATE(PORT_A) |= 0x03u;
    PORT_DIGITAL(PORT_A) |= 0x03u;
    PORT_ALTERNATE(PORT_D) |= 0x0Cu;
    PORT_DIGITAL(PORT_D) |= 0x0Cu;
    begin_line(UART0, 1000000u, UART_INT_RECEIVED | UART_INT_RECEIVED_LAST | UART_INT_SENT);
    begin_line(UART1, 115200u, UART_INT_SENT);
    INTERRUPT_PRIORITY(UART0_INTERRUPT) = 0x40u; // after the tick
    INTERRUPT_PRIORITY(UART1_INTERRUPT) = 0x80u;
    INTERRUPT_ENABLE = (1u << UART0_INTERRUPT) | (1u << UART1_INTERRUPT);
}

// Resets the processor, and with it opens the bridges, when the program has not fed it for twice 5 ms.
static void begin_watchdog(void) {
    SYSTEM_RCGC0 |= 1u << 3;
    (void)SYSTEM_RCGC0;
    WATCHDOG_LOCK = WATCHDOG_KEY;
    WATCHDOG_LOAD = CLOCK_HZ / 200u;
    WATCHDOG_CONTROL = 3u; // the first time is told, the second resets
    WATCHDOG_LOCK = 0;
}

static void feed_watchdog(void) {
    WATCHDOG_LOCK = WATCHDOG_KEY;
    WATCHDOG_LOAD = CLOCK_HZ / 200u;
    WATCHDOG_LOCK = 0;
}

int main(void) {
    begin_clock();
    axes_begin();
    if (!firmware_begin(&firmware, &the_description)) {
        for (;;) { // silent, motors off
        }
    }
    begin_lines();
    SYSTICK_PRIORITY = 0;
    SYSTICK_LOAD = CLOCK_HZ / (1000000u / FIRMWARE_TICK_US) - 1u;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 7u;
    begin_watchdog();
    uint32_t fed_us = 0;
    for (;;) {
        firmware_poll(&firmware);
        const uint32_t now_us = firmware.now_us;
        if (now_us != fed_us) { // fed only while the tick runs, too
            feed_watchdog();
            fed_us = now_us;
        }
        __asm volatile("wfi");
    }
}
