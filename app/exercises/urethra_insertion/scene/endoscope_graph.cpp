// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/endoscope_graph.h"

#include "desktop/scene3d/plugin/qt3d_parts.h"

#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderSettings>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QTextureWrapMode>
#include <algorithm>

namespace chiron::scene3d {

using namespace Qt3DRender;

namespace {

QTexture2D* makeTexture(QAbstractTexture::TextureFormat format, Qt3DCore::QNode* parent) {
    auto* texture = new QTexture2D(parent);
    texture->setFormat(format);
    texture->setSize(2, 2);
    texture->setGenerateMipMaps(false);
    texture->setMinificationFilter(QAbstractTexture::Linear);
    texture->setMagnificationFilter(QAbstractTexture::Linear);
    texture->setWrapMode(QTextureWrapMode(QTextureWrapMode::ClampToEdge));
    return texture;
}

QSubtreeEnabler* makeSwitch(QFrameGraphNode* parent) {
    auto* enabler = new QSubtreeEnabler(parent);
    enabler->setEnabled(false);
    return enabler;
}

} // namespace

EndoscopeGraph::EndoscopeGraph(Qt3DCore::QEntity* root, QObject* surface)
    : m_disc(new QParameter(QStringLiteral("disc"), QVector4D(1, 1, 0, 0), root)),
      m_smallDisc(new QParameter(QStringLiteral("disc"), QVector4D(1, 1, 0, 0), root)),
      m_scope(new QCamera(root)), m_bystander(new QCamera(root)),
      m_seen(makeTexture(QAbstractTexture::RGBA8_UNorm, root)),
      m_depth(makeTexture(QAbstractTexture::D24, root)),
      m_blurred(makeTexture(QAbstractTexture::RGBA8_UNorm, root)) {
    for (QLayer*& layer : m_layers) {
        layer = new QLayer(root);
        layer->setRecursive(true);
    }
    auto* settings = new QRenderSettings(root);
    auto* target = new QRenderSurfaceSelector;
    target->setSurface(surface);
    auto* clear = new QClearBuffers(target);
    clear->setBuffers(QClearBuffers::ColorDepthBuffer);
    clear->setClearColor(Qt::black);
    new QNoDraw(clear);
    makeDirect(target);
    makeDepthOfField(target);
    m_picture[2] = addViewport(target);
    addPass(m_picture[2], marks());
    makeOverview(target);
    auto* window = addViewport(target);
    addPass(window, over(), QClearBuffers::DepthBuffer);
    m_direct->setEnabled(true);
    settings->setActiveFrameGraph(target);
    settings->setRenderPolicy(QRenderSettings::Always); // the window steps the engine itself
    root->addComponent(settings);
}

void EndoscopeGraph::addPass(QFrameGraphNode* parent, QLayer* layer, QClearBuffers::BufferType clear) {
    auto* filter = new QLayerFilter(parent);
    filter->addLayer(layer);
    if (clear == QClearBuffers::None)
        return;
    auto* cleared = new QClearBuffers(filter);
    cleared->setBuffers(clear);
    cleared->setClearColor(Qt::black);
}

QViewport* EndoscopeGraph::addViewport(QFrameGraphNode* parent) {
    auto* viewport = new QViewport(parent);
    viewport->setNormalizedRect(QRectF(0, 0, 1, 1));
    return viewport;
}

QFrameGraphNode* EndoscopeGraph::addTarget(QFrameGraphNode* parent, QTexture2D* colour, QTexture2D* depth) {
    auto* selector = new QRenderTargetSelector(parent);
    auto* target = new QRenderTarget(selector);
    const auto attach = [&](QTexture2D* texture, QRenderTargetOutput::AttachmentPoint point) {
        auto* output = new QRenderTargetOutput(target);
        output->setAttachmentPoint(point);
        output->setTexture(texture);
        target->addOutput(output);
    };
    attach(colour, QRenderTargetOutput::Color0);
    if (depth)
        attach(depth, QRenderTargetOutput::Depth);
    selector->setTarget(target);
    return addViewport(selector);
}

void EndoscopeGraph::drawInside(QFrameGraphNode* parent, const char* look, QParameter* disc) {
    auto* filter = new QRenderPassFilter(parent);
    auto* key = new QFilterKey(filter);
    key->setName(QLatin1String(kLookKey));
    key->setValue(QLatin1String(look));
    filter->addMatch(key);
    filter->addParameter(disc);
    auto* camera = new QCameraSelector(filter);
    camera->setCamera(m_scope);
    addPass(camera, inside());
}

void EndoscopeGraph::makeDirect(QFrameGraphNode* parent) {
    m_direct = makeSwitch(parent);
    m_picture[0] = addViewport(m_direct);
    addPass(m_picture[0], mask());
    drawInside(m_picture[0], kLookPlain, m_disc);
}

void EndoscopeGraph::makeDepthOfField(QFrameGraphNode* parent) {
    m_lens = makeSwitch(parent);
    QFrameGraphNode* small = addTarget(m_lens, m_seen, m_depth);
    addPass(small, mask(), QClearBuffers::ColorDepthBuffer);
    drawInside(small, kLookPlain, m_smallDisc);
    addPass(addTarget(m_lens, m_blurred, nullptr), blur());
    m_picture[1] = addViewport(m_lens);
    addPass(m_picture[1], mask());
    drawInside(m_picture[1], kLookFocus, m_disc);
}

void EndoscopeGraph::makeOverview(QFrameGraphNode* parent) {
    m_outside = makeSwitch(parent);
    m_overview = addViewport(m_outside);
    auto* camera = new QCameraSelector(m_overview);
    camera->setCamera(m_bystander);
    addPass(camera, outside());
    addPass(camera, glass());
    addPass(camera, outsideOver(), QClearBuffers::DepthBuffer);
}

void EndoscopeGraph::setDepthOfField(bool on) {
    m_direct->setEnabled(!on);
    m_lens->setEnabled(on);
}

void EndoscopeGraph::setOverviewShown(bool shown) {
    m_outside->setEnabled(shown);
}

void EndoscopeGraph::place(const EndoscopeLayout& layout, const QSize& window_px) {
    const double wide = std::max(1, window_px.width());
    const double high = std::max(1, window_px.height());
    const auto share = [&](const QRect& r) {
        return QRectF(r.x() / wide, r.y() / high, r.width() / wide, r.height() / high);
    };
    for (QViewport* picture : m_picture)
        picture->setNormalizedRect(share(layout.picture));
    m_overview->setNormalizedRect(share(layout.overview));
    const int side = std::max(2, layout.picture.width());
    const int small = std::max(2, int(kSmall * side));
    for (QTexture2D* texture : {m_seen, m_depth, m_blurred})
        texture->setSize(small, small);
    setDisc(m_disc, side, layout.picture.x(),
            window_px.height() - layout.picture.y() - layout.picture.height());
    setDisc(m_smallDisc, small, 0.0, 0.0);
}

/// gl_FragCoord counts from the lower left corner of the render target.
void EndoscopeGraph::setDisc(QParameter* disc, double side, double left, double bottom) {
    const double unit = 2.0 / side;
    disc->setValue(
        QVector4D(float(unit), float(unit), float(-1.0 - unit * left), float(-1.0 - unit * bottom)));
}

} // namespace chiron::scene3d
