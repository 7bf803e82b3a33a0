// SPDX-License-Identifier: GPL-3.0-or-later
// chiron-station: a haptic station as a program, for trying and testing the whole chain without hardware.
#include "app/station/emulated_station.h"
#include "app/station/holding_hand.h"
#include "app/station/host_line.h"
#include "app/station/station_run.h"
#include "core/fp_environment.h"
#include "devices/driver_catalogue.h"
#include "realtime/realtime_thread.h"

#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace {

using namespace chiron;

std::atomic<bool> g_stop{false}; // the only object that the signal handler may touch

void onSignal(int) {
    g_stop.store(true, std::memory_order_relaxed);
}

std::string mechanisms() {
    std::string ids;
    for (const devices::KinematicsEntry& entry :
         devices::usualDriver(devices::MovedBy::scriptedOperator).kinematics)
        ids += (ids.empty() ? "" : "|") + std::string(entry.id);
    return ids;
}

void printHelp() {
    std::printf(
        "chiron-station: a haptic station as a program. It speaks the station protocol\n"
        "(docs/station-protocol.md) on a TCP port, a pseudo-terminal or a USB HID node, with a simulated\n"
        "mechanism in a scripted hand behind it.\n\n"
        "  --mechanism ID     %s\n"
        "  --jaw              the mechanism as a grasper, where it has a jaw\n"
        "  --tcp PORT         listen on this port; 0: any free one\n"
        "  --bind ADDRESS     of this machine, for --tcp; default: 127.0.0.1, this machine alone\n"
        "  --pty              a pseudo-terminal instead, as a serial line\n"
        "  --link PATH        with --pty: make PATH a link to it\n"
        "  --fuse FOLDER      a file FOLDER/hidraw0 instead, as the node of a USB HID device\n"
        "  --hand WHAT        still: the hand holds the tool; sine: moves it by 3 mm to and fro;\n"
        "                     press: goes 40 mm down after three seconds, and circles; default: still\n"
        "  --lockstep         one tick for each command of the host, instead of 1 kHz by the clock\n"
        "  --fault KIND[:WHEN[:AMOUNT]]\n"
        "                     from WHEN seconds on (default: 1); KIND: %s\n"
        "  --seed S           of the hand's tremor and of the fault; default: 1\n"
        "  --serial TEXT      serial number; default: emulated-0001\n"
        "  --ticks N          end after N milliseconds of its own clock\n"
        "  --once             end when the first host that commanded anything has gone\n\n"
        "It tells its address on standard error and, at its end, one line of JSON on standard output.\n",
        mechanisms().c_str(), station::faultKinds().c_str());
}

struct Options {
    std::string mechanism, bind = "127.0.0.1", link, fuse, fault, serial = "emulated-0001";
    std::optional<std::uint64_t> port;
    bool pty = false, jaw = false, lockstep = false, once = false, help = false;
    station::HoldingHand::Motion hand;
    std::uint64_t seed = 1, ticks = 0;
};

bool readNumber(std::string_view text, std::uint64_t most, std::uint64_t& number) {
    const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stopped == text.data() + text.size() && number <= most;
}

bool readHand(std::string_view word, station::HoldingHand::Motion& hand) {
    hand.amplitude_m = word == "sine" ? 0.003 : 0.0;
    hand.depth_m = word == "press" ? 0.040 : 0.0;
    return word == "still" || word == "sine" || word == "press";
}

core::Result<Options> readOptions(int count, char** words) {
    Options options;
    const auto refuse = [](const std::string& why) {
        return core::fail(core::ErrorCode::wrongUse, why + "; see chiron-station --help");
    };
    for (int i = 1; i < count; ++i) {
        const std::string name = words[i];
        if (name == "--help") {
            options.help = true;
            return options;
        }
        bool* const flag = name == "--pty"        ? &options.pty
                           : name == "--jaw"      ? &options.jaw
                           : name == "--lockstep" ? &options.lockstep
                           : name == "--once"     ? &options.once
                                                  : nullptr;
        if (flag != nullptr) {
            *flag = true;
            continue;
        }
        if (i + 1 >= count)
            return refuse(name + ": unknown, or its value is missing");
        const std::string value = words[++i];
        std::uint64_t port = 0;
        bool right = true;
        if (name == "--mechanism")
            options.mechanism = value;
        else if (name == "--bind")
            options.bind = value;
        else if (name == "--link")
            options.link = value;
        else if (name == "--fuse")
            options.fuse = value;
        else if (name == "--fault")
            options.fault = value;
        else if (name == "--serial")
            right = !(options.serial = value).empty() && value.size() <= 28;
        else if (name == "--seed")
            right = readNumber(value, UINT64_MAX, options.seed);
        else if (name == "--ticks")
            right = readNumber(value, UINT64_MAX, options.ticks);
        else if (name == "--hand")
            right = readHand(value, options.hand);
        else if (name == "--tcp" && (right = readNumber(value, 65'535, port)))
            options.port = port;
        else if (name != "--tcp")
            return refuse(name + ": unknown");
        if (!right)
            return refuse(name + " " + value + ": not a value that it can have");
    }
    if (options.mechanism.empty())
        return refuse("--mechanism is missing");
    if (int{options.port.has_value()} + int{options.pty} + int{!options.fuse.empty()} != 1)
        return refuse("one of --tcp PORT, --pty and --fuse FOLDER is expected");
    return options;
}

core::Result<void> run(const Options& options) {
    station::EmulatedStation::Configuration configuration;
    configuration.mechanism = options.mechanism;
    configuration.seed = options.seed;
    configuration.lockstep = options.lockstep;
    if (options.jaw)
        configuration.shape = devices::ToolShape::grasper;
    configuration.serialNumber = options.serial;
    configuration.strategy = std::make_unique<station::HoldingHand>(options.hand);
    if (!options.fault.empty()) {
        const auto plan = station::readFaultPlan(options.fault);
        CHIRON_TRY(plan);
        configuration.fault = *plan;
    }
    auto made = station::EmulatedStation::create(std::move(configuration));
    CHIRON_TRY(made);
    station::HostLine line;
    CHIRON_TRY(options.pty    ? line.openTerminal(options.link)
               : options.port ? line.listenTcp(options.bind, static_cast<std::uint16_t>(*options.port))
                              : line.openHidraw(options.fuse, options.serial));
    std::fprintf(stderr, "chiron-station: %s at %s\n", (*made)->descriptor().model.c_str(),
                 line.address().c_str());
    const station::RunLimits limits{options.ticks, options.once};
    if (options.lockstep) {
        CHIRON_TRY(station::runLockstep(**made, line, limits, g_stop));
    } else {
        (void)realtime::setUpRealtimeThread();
        CHIRON_TRY(station::runByClock(**made, line, limits, g_stop));
    }
    std::printf("%s\n", station::totalsJson((*made)->totals(), (*made)->descriptor().axes.size()).c_str());
    return {};
}

} // namespace

int main(int count, char** words) {
    const auto options = readOptions(count, words);
    if (options && options->help) {
        printHelp();
        return 0;
    }
    core::setModelFloatingPointEnvironment();
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    std::signal(SIGPIPE, SIG_IGN);
    const auto done = options ? run(*options) : core::Result<void>(tl::unexpected(options.error()));
    if (done)
        return 0;
    std::fprintf(stderr, "chiron-station: %s\n", done.error().message.c_str());
    return done.error().code == core::ErrorCode::device ? 5 : 2;
}
