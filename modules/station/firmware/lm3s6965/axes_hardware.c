// SPDX-License-Identifier: GPL-3.0-or-later
// board.h's functions about axes by the LM3S6965's own encoders, bridges and converter: two axes with motors
// (README.md has the pins). Never run on hardware.
#include "station/firmware/board.h"
#include "station/firmware/lm3s6965/axes.h"
#include "station/firmware/lm3s6965/registers.h"
#include "station/protocol/station_frame.h"

#define AXES 2
#define PWM_PERIOD 1000u // clocks of 20 ns: 50 kHz, and a thousandth is one clock
#define CURRENT_ZERO 512 // of the amplifier at half of 3 V
#define CURRENT_GAIN 29  // mA a step: 3 V / 1024 by 0.1 V/A
#define SUPPLY_GAIN 29   // mV a step: by a divider of ten
#define PINS_PER_MOTOR 0x3u

static const uint32_t encoders[AXES] = {QEI0, QEI1};
static int32_t counts[AXES];
static int32_t currents_mA[AXES];
static uint16_t supply_mV;
static uint8_t fault;

void axes_begin(void) {
    SYSTEM_RCGC0 |= (1u << 16) | (1u << 20); // converter, pulse widths
    SYSTEM_RCGC1 |= (1u << 8) | (1u << 9);   // both encoders
    SYSTEM_RCGC2 |= 0x3Fu;                   // ports A to F
    (void)SYSTEM_RCGC2;
    PORT_ALTERNATE(PORT_C) |= 0x90u; // PC4, PC7: encoder 1
    PORT_DIGITAL(PORT_C) |= 0x90u;
    PORT_ALTERNATE(PORT_E) |= 0x0Cu; // PE3, PE2: encoder 2
    PORT_DIGITAL(PORT_E) |= 0x0Cu;
    PORT_ALTERNATE(PORT_F) |= 0x01u; // PF0, PD1: motor 1
    PORT_DIGITAL(PORT_F) |= 0x01u;
    PORT_ALTERNATE(PORT_D) |= 0x42u; // PD6: emergency stop, which stops the bridges by itself
    PORT_DIGITAL(PORT_D) |= 0x42u;
    PORT_ALTERNATE(PORT_B) |= 0x03u; // PB0, PB1: motor 2
    PORT_DIGITAL(PORT_B) |= 0x03u;
    PORT_PULL_UP(PORT_A) |= 0xC0u; // PA6 dead-man switch, PA7 button: to ground
    PORT_DIGITAL(PORT_A) |= 0xC0u;
    for (uint32_t axis = 0; axis < AXES; ++axis) {
        QEI_MOST(encoders[axis]) = 0xFFFFFFFFu;
        QEI_CONTROL(encoders[axis]) = 0x09u; // every edge of both phases, on
        PWM_LOAD(axis) = PWM_PERIOD - 1u;
        PWM_COMPARE_A(axis) = PWM_PERIOD - 1u;
        PWM_COMPARE_B(axis) = PWM_PERIOD - 1u;
        PWM_ACTION_A(axis) = 0x8Cu; // high at the start of a period, low from the comparison on: counts down
        PWM_ACTION_B(axis) = 0x80Cu;
        PWM_CONTROL(axis) = 1u;
    }
    PWM_FAULT_STOPS = 0x0Fu;
    ADC_ACTIVE = 0;
    ADC_TRIGGERS = 0;    // by program
    ADC_INPUTS = 0x210u; // currents of both motors, supply
    ADC_STEPS = 0x200u;  // the third is the last
    ADC_ACTIVE = 1u;
    ADC_START = 1u;
}

static uint32_t next_result(void) {
    return (ADC_RESULT_STATE & ADC_RESULT_NONE) ? 0 : ADC_RESULT & 0x3FFu;
}

void board_tick(void) {
    fault = (PWM_STATUS & 1u) ? STATION_EMERGENCY_STOP : STATION_NO_FAULT;
    for (uint32_t axis = 0; axis < AXES; ++axis) {
        counts[axis] = (int32_t)QEI_POSITION(encoders[axis]);
        currents_mA[axis] = ((int32_t)next_result() - CURRENT_ZERO) * CURRENT_GAIN;
        if (QEI_EVENTS(encoders[axis]) & QEI_EVENT_ERROR) {
            QEI_CLEAR(encoders[axis]) = QEI_EVENT_ERROR;
            fault = STATION_ENCODER_FAULT;
        }
    }
    supply_mV = (uint16_t)(next_result() * SUPPLY_GAIN);
    ADC_START = 1u; // ready long before the next tick
}

int32_t board_counts(uint8_t axis) {
    return axis < AXES ? counts[axis] : 0;
}

int32_t board_current_mA(uint8_t axis) {
    return axis < AXES ? currents_mA[axis] : 0;
}

void board_drive(uint8_t axis, int32_t duty_permille) {
    if (axis >= AXES)
        return;
    const uint32_t size = (uint32_t)(duty_permille < 0 ? -duty_permille : duty_permille);
    const uint32_t low_from = PWM_PERIOD - 1u - (size < PWM_PERIOD - 1u ? size : PWM_PERIOD - 1u);
    PWM_COMPARE_A(axis) = duty_permille > 0 ? low_from : PWM_PERIOD - 1u;
    PWM_COMPARE_B(axis) = duty_permille < 0 ? low_from : PWM_PERIOD - 1u;
    PWM_ENABLE |= PINS_PER_MOTOR << (2u * axis);
}

void board_motors_off(void) {
    PWM_ENABLE = 0;
}

bool board_dead_man(void) {
    return (PORT_DATA(PORT_A) & 0x40u) == 0;
}

uint8_t board_buttons(void) {
    return (PORT_DATA(PORT_A) & 0x80u) == 0 ? 1 : 0;
}

uint16_t board_supply_mV(void) {
    return supply_mV;
}

uint8_t board_fault(void) {
    return fault;
}
