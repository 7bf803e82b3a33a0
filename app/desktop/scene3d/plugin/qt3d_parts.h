// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/drawn_mesh.h"

#include <QByteArray>
#include <QColor>
#include <QQuaternion>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace chiron::scene3d {

/// Uploads a triangle mesh to the driver. setMesh() replaces it.
class MeshRenderer final : public Qt3DRender::QGeometryRenderer {
public:
    explicit MeshRenderer(const TriangleMesh& mesh, Qt3DCore::QNode* parent = nullptr);
    void setMesh(const TriangleMesh& mesh);

private:
    Qt3DCore::QBuffer* m_vertices;
    Qt3DCore::QBuffer* m_indices;
    Qt3DCore::QAttribute* m_places[4];
    Qt3DCore::QAttribute* m_order;
};

/// The filter key by which a frame graph that draws the same entities in two looks selects one of them.
inline constexpr const char* kLookKey = "look";
inline constexpr const char* kLookPlain = "plain";
inline constexpr const char* kLookFocus = "focus";

enum class Blend { opaque, translucent, premultiplied };

/// The effects of a scene. Materials with the same shaders share one effect, so that each shader is compiled
/// only once and reports when it is ready (a second node with the same source never does).
class EffectShelf {
public:
    explicit EffectShelf(Qt3DCore::QNode* owner) : m_owner(owner) {}

    /// Creates a material with the two named shaders (in shaders/) and its own parameters.
    Qt3DRender::QMaterial* material(const char* vertexShader, const char* fragmentShader,
                                    const std::vector<Qt3DRender::QParameter*>& parameters, Blend blend,
                                    Qt3DCore::QNode* parent);
    /// Returns the effect alone. `tools` ≥ 0 is for a fragment shader of the field, which gets shadowOf() for
    /// that many tips, after the lines `defines` ("#define NAME\n").
    Qt3DRender::QEffect* effect(const char* vertexShader, const char* fragmentShader, Blend blend,
                                int tools = -1, const QByteArray& defines = {});
    /// The same with lines inserted into the fragment shader after #version ("#define NAME\n"), so that one
    /// file serves several looks. With BOTH_SIDES the triangles are drawn from both sides. With LAMP the
    /// vertex shader gets lamp.glsl, and a second pass with FOCUS defined serves kLookFocus; every other pass
    /// serves both looks.
    Qt3DRender::QMaterial* materialWith(const char* defines, const char* vertexShader,
                                        const char* fragmentShader,
                                        const std::vector<Qt3DRender::QParameter*>& parameters, Blend blend,
                                        Qt3DCore::QNode* parent);

private:
    Qt3DCore::QNode* m_owner;
    void addPass(Qt3DRender::QTechnique* technique, const char* vertexShader, const char* fragmentShader,
                 Blend blend, const QByteArray& head, const std::vector<const char*>& looks) const;
    Qt3DRender::QEffect* made(const char* vertexShader, const char* fragmentShader, Blend blend,
                              const QByteArray& head);
    std::map<std::tuple<std::string, std::string, Blend, QByteArray>, Qt3DRender::QEffect*> m_effects;
};

/// An entity with this mesh, this material and its own transform.
class Part final : public Qt3DCore::QEntity {
public:
    Part(const TriangleMesh& mesh, Qt3DRender::QMaterial* material, Qt3DCore::QNode* parent);
    Qt3DCore::QTransform& at() { return *m_transform; }
    MeshRenderer& mesh() { return *m_mesh; }
    Qt3DRender::QMaterial* material() const { return m_material; }
    bool isShown() const; ///< this entity and all its ancestors are enabled

private:
    MeshRenderer* m_mesh;
    Qt3DRender::QMaterial* m_material;
    Qt3DCore::QTransform* m_transform;
};

inline QVector3D toMillimetres(const core::Vec3& p_m) {
    return {float(p_m.x() * 1e3), float(p_m.y() * 1e3), float(p_m.z() * 1e3)};
}
inline QVector3D toVector(const core::Vec3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}
inline QQuaternion toQuaternion(const core::Quat& q) {
    return {float(q.w()), float(q.x()), float(q.y()), float(q.z())};
}
inline QVector4D toTint(const QColor& colour, float opacity = 1.0F) {
    return {float(colour.redF()), float(colour.greenF()), float(colour.blueF()), opacity};
}

} // namespace chiron::scene3d
