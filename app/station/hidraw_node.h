// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "station/stream/frame_stream.h"

#include <memory>
#include <string>

namespace chiron::station {

/// USB's numbers of maker and product for trials (pid.codes).
inline constexpr unsigned kTrialVendor = 0x1209;
inline constexpr unsigned kTrialProduct = 0x0001;

/// A file that answers as the kernel's hidraw node of a USB HID station does: FOLDER/hidraw0, by FUSE. So the
/// real hidapi can be tried on a computer without such a device. Reports that the host does not take wait in
/// a ring of 64, as in the kernel; what comes when it is full is lost. Thread: the functions are called by
/// one; two of its own serve the file.
class HidrawNode {
public:
    /// Shows the file in an empty folder.
    /// Errors: device, if FUSE may not be used here.
    static core::Result<std::unique_ptr<HidrawNode>> serve(const std::string& folder);
    ~HidrawNode(); ///< the folder is empty again

    /// The station's end: frames that it sends become input reports, and output reports come as frames.
    FrameStream plugIn();
    /// The host's next call fails, as with a device that was pulled out.
    void unplug() noexcept;

private:
    struct Served;
    explicit HidrawNode(std::unique_ptr<Served> served);
    std::unique_ptr<Served> m_served;
};

} // namespace chiron::station
