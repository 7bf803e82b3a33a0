// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::operators {

/// Interface through which the runner of a study queries a simulated participant, after each tick and on the
/// same thread.
class IParticipantMind {
public:
    IParticipantMind() = default;
    IParticipantMind(const IParticipantMind&) = delete;
    IParticipantMind& operator=(const IParticipantMind&) = delete;
    virtual ~IParticipantMind() = default;

    /// Returns true once every place of the present trial has been explored, so that an answer can be given.
    virtual bool explored() const noexcept = 0;
    /// Returns the participant's own estimate of the attribute at a place, in SI units; NaN where nothing
    /// usable was felt.
    virtual double estimate(int place) const noexcept = 0;
    /// Makes it explore once more (because an adjustment changed the level).
    virtual void again() noexcept = 0;
};

} // namespace chiron::operators
