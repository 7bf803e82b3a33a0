// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <unistd.h>

namespace chiron::tests {

/// A view of this computer in which USB HID devices are plugged in that are not there: folders of this
/// process and its children alone, in which udev reads as much of a device as hidapi asks for. The node
/// itself is FOLDER/hidraw0 of chiron-station --fuse.
class HidComputer {
public:
    /// Makes the view, before the program starts a thread. False where it may not: it takes root and
    /// /dev/fuse.
    static bool enter() {
        namespace fs = std::filesystem;
        if (::geteuid() != 0 || !fs::exists("/dev/fuse") || ::unshare(CLONE_NEWNS) != 0 ||
            ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("none", "/sys", "tmpfs", 0, nullptr) != 0 ||
            ::mount("none", "/dev/shm", "tmpfs", 0, nullptr) != 0)
            return false;
        for (const char* folder : {"/dev/shm/hid", "/sys/class/hidraw", "/sys/bus/usb", "/sys/bus/hid"})
            fs::create_directories(folder);
        ::setenv("SYSTEMD_DEVICE_VERIFY_SYSFS", "0", 1); // udev takes a /sys that is none of the kernel's
        return true;
    }

    /// Where the node of the first device is to be shown.
    static constexpr const char* kFolder = "/dev/shm/hid";

    /// The file through which programs reach a device: number 0 is the one in kFolder, others are for the
    /// test to make.
    static std::string nodeOf(int number) {
        return number == 0 ? std::string(kFolder) + "/hidraw0" : "/dev/shm/hidraw" + std::to_string(number);
    }

    /// Plugs in a device of the emulated station's numbers.
    static void plugIn(int number, const std::string& serialNumber) {
        namespace fs = std::filesystem;
        const std::string n = std::to_string(number), usb = usbFolder(number), interface = usb + "/1-1:1.0";
        const std::string hid = interface + "/0003:1209:0001.000" + n, node = "hidraw" + n;
        fs::create_directories(hid + "/hidraw/" + node);
        write(usb + "/uevent", "DEVTYPE=usb_device\nPRODUCT=1209/1/100\n");
        write(usb + "/manufacturer", "Chiron\n");
        write(usb + "/product", "Emulated station\n");
        write(usb + "/serial", serialNumber + "\n");
        write(usb + "/bcdDevice", "0100\n");
        write(usb + "/idVendor", "1209\n");
        write(usb + "/idProduct", "0001\n");
        write(interface + "/uevent", "DEVTYPE=usb_interface\n");
        write(interface + "/bInterfaceNumber", "00\n");
        write(hid + "/uevent",
              "DRIVER=hid-generic\nHID_ID=0003:00001209:00000001\nHID_NAME=Emulated station\n"
              "HID_PHYS=sim/input0\nHID_UNIQ=" +
                  serialNumber + "\n");
        const unsigned char page[] = {0x06, 0x00, 0xFF, 0x0A, 0x48, 0x43, 0xA1, 0x01, 0xC0};
        write(hid + "/report_descriptor", std::string(reinterpret_cast<const char*>(page), sizeof page));
        write(hid + "/hidraw/" + node + "/uevent",
              "MAJOR=240\nMINOR=" + n + "\nDEVNAME=" + nodeOf(number).substr(sizeof "/dev") + "\n");
        fs::create_directory_symlink("/sys/bus/usb", usb + "/subsystem");
        fs::create_directory_symlink("/sys/bus/usb", interface + "/subsystem");
        fs::create_directory_symlink("/sys/bus/hid", hid + "/subsystem");
        fs::create_directory_symlink("/sys/class/hidraw", hid + "/hidraw/" + node + "/subsystem");
        fs::create_directory_symlink(hid, hid + "/hidraw/" + node + "/device");
        fs::create_directory_symlink(hid + "/hidraw/" + node, "/sys/class/hidraw/" + node);
    }
    static void pullOut(int number) {
        std::filesystem::remove("/sys/class/hidraw/hidraw" + std::to_string(number));
        std::filesystem::remove_all(usbFolder(number));
    }

private:
    static std::string usbFolder(int number) {
        return "/sys/devices/pci0000:00/usb" + std::to_string(number + 1) + "/1-1";
    }
    static void write(const std::string& path, const std::string& bytes) {
        std::ofstream(path, std::ios::binary) << bytes;
    }
};

} // namespace chiron::tests
