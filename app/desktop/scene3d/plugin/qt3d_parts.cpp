// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/qt3d_parts.h"

#include <QUrl>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QRenderPass>

namespace chiron::scene3d {

using Qt3DCore::QAttribute;

MeshRenderer::MeshRenderer(const TriangleMesh& mesh, Qt3DCore::QNode* parent) : QGeometryRenderer(parent) {
    auto* geometry = new Qt3DCore::QGeometry(this);
    m_vertices = new Qt3DCore::QBuffer(geometry);
    m_indices = new Qt3DCore::QBuffer(geometry);
    static constexpr struct {
        const char* name;
        uint size;
        uint offset;
    } kFields[4] = {{"vertexPosition", 3, offsetof(MeshVertex, position_mm)},
                    {"vertexNormal", 3, offsetof(MeshVertex, normal)},
                    {"vertexTexCoord", 2, offsetof(MeshVertex, texture)},
                    {"vertexLight", 1, offsetof(MeshVertex, light)}};
    for (int i = 0; i < 4; ++i) {
        m_places[i] = new QAttribute(m_vertices, QLatin1String(kFields[i].name), QAttribute::Float,
                                     kFields[i].size, 0, kFields[i].offset, sizeof(MeshVertex), geometry);
        geometry->addAttribute(m_places[i]);
    }
    m_order = new QAttribute(m_indices, QAttribute::UnsignedInt, 1, 0, 0, 0, geometry);
    m_order->setAttributeType(QAttribute::IndexAttribute);
    geometry->addAttribute(m_order);
    geometry->setBoundingVolumePositionAttribute(m_places[0]);
    setGeometry(geometry);
    setMesh(mesh);
}

void MeshRenderer::setMesh(const TriangleMesh& mesh) {
    const auto bytes = [](const auto& values) {
        return QByteArray(reinterpret_cast<const char*>(values.data()),
                          qsizetype(values.size() * sizeof(values[0])));
    };
    m_vertices->setData(bytes(mesh.vertices));
    m_indices->setData(bytes(mesh.indices));
    for (QAttribute* place : m_places)
        place->setCount(uint(mesh.vertices.size()));
    m_order->setCount(uint(mesh.indices.size()));
    setVertexCount(int(mesh.indices.size()));
}

namespace {

void addBlend(Qt3DRender::QRenderPass* pass, Blend blend) {
    using Arguments = Qt3DRender::QBlendEquationArguments;
    auto* depth = new Qt3DRender::QDepthTest(pass);
    depth->setDepthFunction(Qt3DRender::QDepthTest::LessOrEqual);
    pass->addRenderState(depth);
    if (blend == Blend::opaque)
        return;
    pass->addRenderState(new Qt3DRender::QNoDepthMask(pass));
    auto* arguments = new Arguments(pass);
    arguments->setSourceRgb(blend == Blend::premultiplied ? Arguments::One : Arguments::SourceAlpha);
    arguments->setDestinationRgb(Arguments::OneMinusSourceAlpha);
    arguments->setSourceAlpha(Arguments::One);
    arguments->setDestinationAlpha(Arguments::One);
    auto* equation = new Qt3DRender::QBlendEquation(pass);
    equation->setBlendFunction(Qt3DRender::QBlendEquation::Add);
    pass->addRenderState(arguments);
    pass->addRenderState(equation);
}

QByteArray source(const char* name) {
    return Qt3DRender::QShaderProgram::loadSource(
        QUrl(QStringLiteral("qrc:/chiron/scene3d/") + QLatin1String(name)));
}

} // namespace

Qt3DRender::QEffect* EffectShelf::effect(const char* vertexShader, const char* fragmentShader, Blend blend,
                                         int tools, const QByteArray& defines) {
    return made(vertexShader, fragmentShader, blend,
                tools >= 0
                    ? defines + "#define TOOLS " + QByteArray::number(tools) + '\n' + source("shadow.glsl")
                    : defines);
}

void EffectShelf::addPass(Qt3DRender::QTechnique* technique, const char* vertexShader,
                          const char* fragmentShader, Blend blend, const QByteArray& head,
                          const std::vector<const char*>& looks) const {
    auto* pass = new Qt3DRender::QRenderPass(technique);
    auto* program = new Qt3DRender::QShaderProgram(pass);
    QByteArray vertex = source(vertexShader);
    if (head.contains("LAMP"))
        vertex.insert(vertex.indexOf('\n') + 1, source("lamp.glsl"));
    program->setVertexShaderCode(vertex);
    QByteArray fragment = source(fragmentShader);
    fragment.insert(fragment.indexOf('\n') + 1, head); // inserted after #version
    program->setFragmentShaderCode(fragment);
    pass->setShaderProgram(program);
    addBlend(pass, blend);
    if (head.contains("BOTH_SIDES")) {
        auto* cull = new Qt3DRender::QCullFace(pass);
        cull->setMode(Qt3DRender::QCullFace::NoCulling);
        pass->addRenderState(cull);
    }
    for (const char* look : looks) {
        auto* key = new Qt3DRender::QFilterKey(pass);
        key->setName(QLatin1String(kLookKey));
        key->setValue(QLatin1String(look));
        pass->addFilterKey(key);
    }
    technique->addRenderPass(pass);
}

Qt3DRender::QEffect* EffectShelf::made(const char* vertexShader, const char* fragmentShader, Blend blend,
                                       const QByteArray& head) {
    Qt3DRender::QEffect*& effect = m_effects[{vertexShader, fragmentShader, blend, head}];
    if (effect)
        return effect;
    effect = new Qt3DRender::QEffect(m_owner);
    auto* technique = new Qt3DRender::QTechnique(effect);
    technique->graphicsApiFilter()->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    technique->graphicsApiFilter()->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    technique->graphicsApiFilter()->setMajorVersion(3);
    technique->graphicsApiFilter()->setMinorVersion(2);
    if (head.contains("LAMP")) {
        addPass(technique, vertexShader, fragmentShader, blend, head, {kLookPlain});
        addPass(technique, vertexShader, fragmentShader, blend, head + "#define FOCUS\n", {kLookFocus});
    } else {
        addPass(technique, vertexShader, fragmentShader, blend, head, {kLookPlain, kLookFocus});
    }
    effect->addTechnique(technique);
    return effect;
}

Qt3DRender::QMaterial* EffectShelf::material(const char* vertexShader, const char* fragmentShader,
                                             const std::vector<Qt3DRender::QParameter*>& parameters,
                                             Blend blend, Qt3DCore::QNode* parent) {
    return materialWith("", vertexShader, fragmentShader, parameters, blend, parent);
}

Qt3DRender::QMaterial* EffectShelf::materialWith(const char* defines, const char* vertexShader,
                                                 const char* fragmentShader,
                                                 const std::vector<Qt3DRender::QParameter*>& parameters,
                                                 Blend blend, Qt3DCore::QNode* parent) {
    auto* material = new Qt3DRender::QMaterial(parent);
    material->setEffect(made(vertexShader, fragmentShader, blend, defines));
    for (Qt3DRender::QParameter* parameter : parameters)
        material->addParameter(parameter);
    return material;
}

Part::Part(const TriangleMesh& mesh, Qt3DRender::QMaterial* material, Qt3DCore::QNode* parent)
    : QEntity(parent), m_mesh(new MeshRenderer(mesh, this)), m_material(material),
      m_transform(new Qt3DCore::QTransform(this)) {
    addComponent(m_mesh);
    addComponent(material);
    addComponent(m_transform);
}

bool Part::isShown() const {
    for (const Qt3DCore::QNode* node = this; node; node = node->parentNode())
        if (!node->isEnabled())
            return false;
    return true;
}

} // namespace chiron::scene3d
