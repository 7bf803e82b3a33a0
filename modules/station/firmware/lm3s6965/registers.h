// SPDX-License-Identifier: GPL-3.0-or-later
// The few registers of the LM3S6965 and of its Cortex-M3 that the firmware uses, by their addresses in the
// data sheet.
#ifndef CHIRON_FIRMWARE_REGISTERS_H
#define CHIRON_FIRMWARE_REGISTERS_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

// System control
#define SYSTEM_RIS REGISTER(0x400FE050u)
#define SYSTEM_RCC REGISTER(0x400FE060u)
#define SYSTEM_RCGC0 REGISTER(0x400FE100u)
#define SYSTEM_RCGC1 REGISTER(0x400FE104u)
#define SYSTEM_RCGC2 REGISTER(0x400FE108u)

// Ports
#define PORT_A 0x40004000u
#define PORT_B 0x40005000u
#define PORT_C 0x40006000u
#define PORT_D 0x40007000u
#define PORT_E 0x40024000u
#define PORT_F 0x40025000u
#define PORT_DATA(port) REGISTER((port) + 0x3FCu)
#define PORT_DIRECTION(port) REGISTER((port) + 0x400u)
#define PORT_ALTERNATE(port) REGISTER((port) + 0x420u)
#define PORT_PULL_UP(port) REGISTER((port) + 0x510u)
#define PORT_DIGITAL(port) REGISTER((port) + 0x51Cu)

// Serial lines
#define UART0 0x4000C000u
#define UART1 0x4000D000u
#define UART_DATA(uart) REGISTER((uart) + 0x00u)
#define UART_FLAGS(uart) REGISTER((uart) + 0x18u)
#define UART_WHOLE_DIVISOR(uart) REGISTER((uart) + 0x24u)
#define UART_PART_DIVISOR(uart) REGISTER((uart) + 0x28u)
#define UART_LINE(uart) REGISTER((uart) + 0x2Cu)
#define UART_CONTROL(uart) REGISTER((uart) + 0x30u)
#define UART_LEVELS(uart) REGISTER((uart) + 0x34u)
#define UART_MASK(uart) REGISTER((uart) + 0x38u)
#define UART_CLEAR(uart) REGISTER((uart) + 0x44u)
#define UART_FLAG_RECEIVED_NONE 0x10u
#define UART_FLAG_SEND_FULL 0x20u
#define UART_INT_RECEIVED 0x10u
#define UART_INT_SENT 0x20u
#define UART_INT_RECEIVED_LAST 0x40u // some came, and then none for a while

// Watchdog
#define WATCHDOG_LOAD REGISTER(0x40000000u)
#define WATCHDOG_CONTROL REGISTER(0x40000008u)
#define WATCHDOG_LOCK REGISTER(0x40000C00u)
#define WATCHDOG_KEY 0x1ACCE551u

// Encoders
#define QEI0 0x4002C000u
#define QEI1 0x4002D000u
#define QEI_CONTROL(qei) REGISTER((qei) + 0x00u)
#define QEI_POSITION(qei) REGISTER((qei) + 0x08u)
#define QEI_MOST(qei) REGISTER((qei) + 0x0Cu)
#define QEI_EVENTS(qei) REGISTER((qei) + 0x24u)
#define QEI_CLEAR(qei) REGISTER((qei) + 0x28u)
#define QEI_EVENT_ERROR 0x08u

// Pulse widths
#define PWM_ENABLE REGISTER(0x40028008u)
#define PWM_FAULT_STOPS REGISTER(0x40028010u)
#define PWM_STATUS REGISTER(0x40028020u)
#define PWM_CONTROL(n) REGISTER(0x40028040u + 0x40u * (n))
#define PWM_LOAD(n) REGISTER(0x40028050u + 0x40u * (n))
#define PWM_COMPARE_A(n) REGISTER(0x40028058u + 0x40u * (n))
#define PWM_COMPARE_B(n) REGISTER(0x4002805Cu + 0x40u * (n))
#define PWM_ACTION_A(n) REGISTER(0x40028060u + 0x40u * (n))
#define PWM_ACTION_B(n) REGISTER(0x40028064u + 0x40u * (n))

// Converter
#define ADC_ACTIVE REGISTER(0x40038000u)
#define ADC_TRIGGERS REGISTER(0x40038014u)
#define ADC_START REGISTER(0x40038028u)
#define ADC_INPUTS REGISTER(0x40038040u)
#define ADC_STEPS REGISTER(0x40038044u)
#define ADC_RESULT REGISTER(0x40038048u)
#define ADC_RESULT_STATE REGISTER(0x4003804Cu)
#define ADC_RESULT_NONE 0x100u

// Cortex-M3
#define SYSTICK_CONTROL REGISTER(0xE000E010u)
#define SYSTICK_LOAD REGISTER(0xE000E014u)
#define SYSTICK_VALUE REGISTER(0xE000E018u)
#define INTERRUPT_ENABLE REGISTER(0xE000E100u)
#define INTERRUPT_PRIORITY(n) (*(volatile uint8_t*)(0xE000E400u + (n)))
#define SYSTICK_PRIORITY (*(volatile uint8_t*)0xE000ED23u)

#endif
