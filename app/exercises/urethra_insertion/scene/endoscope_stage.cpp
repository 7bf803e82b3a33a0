// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/endoscope_stage.h"

#include <cmath>

namespace chiron::scene3d {

EndoscopeStage::EndoscopeStage(const SceneSetup& setup, QObject* surface)
    : m_setup(setup), m_root(new Qt3DCore::QEntity), m_light(m_root), m_graph(m_root, surface),
      m_model(setup.parameters.as<simulation::UrethraInsertionParameters>(), m_root),
      m_picture(m_model, m_light.effects, m_graph, m_root),
      m_landmarks(m_model.drawing(), m_light.effects, m_picture.bladder()),
      m_marks(m_light.effects, m_graph.marks(), m_root), m_notice(m_light.effects, m_graph.marks(), m_root),
      m_overview(m_model, m_light, m_graph, m_root),
      m_gauge(new ForceGauge(m_light, ForceGauge::Side::right, m_root)),
      m_note(new NoteCard(m_light, m_root)) {
    m_gauge->addComponent(m_graph.over());
    m_note->addComponent(m_graph.over());
    change(setup);
    show(SceneState{});
}

void EndoscopeStage::change(const SceneSetup& setup) {
    m_setup = setup;
    m_light.change(setup);
    m_picture.change(setup);
    m_landmarks.change(setup);
    m_marks.change(setup);
    m_notice.change(setup);
    m_overview.change(setup);
    m_gauge->change(setup, forceDial(setup), setup.cues.arrow);
    m_note->change(setup);
    place();
}

void EndoscopeStage::show(const SceneState& state) {
    m_model.show(state.tool[0]);
    const ScopeMarks marks = ScopeMarks::of(m_setup, m_model.drawing(), state);
    m_picture.show(state.tool[0], marks.pictureShown);
    m_landmarks.show(state);
    m_marks.show(marks);
    m_notice.show(!m_setup.cues.object || !state.objectShown);
    m_overview.show(state);
    m_gauge->show(largestForce_N(state));
    m_note->show(state.note);
}

void EndoscopeStage::setPicture(const QSize& size_px, double ratio) {
    m_size_px = size_px;
    m_ratio = ratio;
    m_light.setSize_px(size_px);
    m_gauge->setPicture(size_px, ratio);
    m_note->setPicture(size_px, ratio);
    place();
}

void EndoscopeStage::place() {
    const int bar_px = int(std::ceil(m_gauge->widthShare() * m_size_px.width()));
    const EndoscopeLayout layout = EndoscopeLayout::of(m_size_px, bar_px, m_setup.cues.overview);
    m_graph.place(layout, m_size_px);
    m_picture.place(layout.picture.width());
    m_notice.setPicture(layout.picture.width(), m_ratio);
    if (m_setup.cues.overview)
        m_overview.place(layout.overview);
}

} // namespace chiron::scene3d
