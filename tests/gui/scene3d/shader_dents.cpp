// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/scene3d/shader_dents.h"

#include <QFile>
#include <QMatrix4x4>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <cstring>

namespace chiron::scene3d {

namespace {

constexpr const char* kFields[] = {"vertexPosition", "vertexNormal", "vertexTexCoord", "vertexLight"};

/// A program of the vertex shader alone that keeps `place`; 0 on failure.
GLuint program(QOpenGLExtraFunctions& gl, const QByteArray& source, QString& error) {
    const GLuint shader = gl.glCreateShader(GL_VERTEX_SHADER);
    const char* text = source.constData();
    gl.glShaderSource(shader, 1, &text, nullptr);
    gl.glCompileShader(shader);
    const GLuint made = gl.glCreateProgram();
    gl.glAttachShader(made, shader);
    for (GLuint i = 0; i < 4; ++i)
        gl.glBindAttribLocation(made, i, kFields[i]);
    const char* kept = "place";
    gl.glTransformFeedbackVaryings(made, 1, &kept, GL_INTERLEAVED_ATTRIBS);
    gl.glLinkProgram(made);
    GLint linked = 0;
    gl.glGetProgramiv(made, GL_LINK_STATUS, &linked);
    if (linked)
        return made;
    char log[2000] = "";
    gl.glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    error = QString::fromLatin1(log);
    return 0;
}

void setDents(QOpenGLExtraFunctions& gl, GLuint made, const std::vector<Dent>& dents) {
    QMatrix4x4 places = QMatrix4x4() * 0.0F;
    QMatrix4x4 normals;
    for (std::size_t i = 0; i < dents.size() && i < 4; ++i) {
        const Dent& d = dents[i];
        const core::Vec3 s = d.p_WSurface * 1e3;
        places.setColumn(int(i), QVector4D(float(s.x()), float(s.y()), float(s.z()), float(d.depth_m * 1e3)));
        normals.setColumn(int(i), QVector4D(float(d.normal.x()), float(d.normal.y()), float(d.normal.z()),
                                            float(d.reach_m * 1e3)));
    }
    gl.glUniformMatrix4fv(gl.glGetUniformLocation(made, "dentPlace"), 1, GL_FALSE, places.constData());
    gl.glUniformMatrix4fv(gl.glGetUniformLocation(made, "dentNormal"), 1, GL_FALSE, normals.constData());
    gl.glUniformMatrix4fv(gl.glGetUniformLocation(made, "mvp"), 1, GL_FALSE, QMatrix4x4().constData());
}

std::vector<float> run(QOpenGLExtraFunctions& gl, const TriangleMesh& mesh) {
    GLuint array = 0;
    GLuint buffers[2] = {0, 0};
    const auto count = GLsizei(mesh.vertices.size());
    gl.glGenVertexArrays(1, &array);
    gl.glBindVertexArray(array);
    gl.glGenBuffers(2, buffers);
    gl.glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(count * GLsizei(sizeof(MeshVertex))), mesh.vertices.data(),
                    GL_STATIC_DRAW);
    const GLint sizes[] = {3, 3, 2, 1};
    const std::size_t offsets[] = {offsetof(MeshVertex, position_mm), offsetof(MeshVertex, normal),
                                   offsetof(MeshVertex, texture), offsetof(MeshVertex, light)};
    for (GLuint i = 0; i < 4; ++i) {
        gl.glEnableVertexAttribArray(i);
        gl.glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                                 reinterpret_cast<const void*>(offsets[i]));
    }
    std::vector<float> places(std::size_t(count) * 3);
    const auto bytes = GLsizeiptr(places.size() * sizeof(float));
    gl.glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1]);
    gl.glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_READ);
    gl.glEnable(GL_RASTERIZER_DISCARD);
    gl.glBeginTransformFeedback(GL_POINTS);
    gl.glDrawArrays(GL_POINTS, 0, count);
    gl.glEndTransformFeedback();
    gl.glFinish();
    if (const void* mapped = gl.glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT))
        std::memcpy(places.data(), mapped, std::size_t(bytes));
    return places;
}

} // namespace

std::vector<core::Vec3> displacedByShader(const TriangleMesh& mesh, const std::vector<Dent>& dents,
                                          QString& error) {
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/app/desktop/scene3d/shaders/tissue.vert"));
    if (!context.create() || !context.makeCurrent(&surface) || !file.open(QIODevice::ReadOnly)) {
        error = QStringLiteral("no context, or no shader file");
        return {};
    }
    QOpenGLExtraFunctions& gl = *context.extraFunctions();
    const GLuint made = program(gl, file.readAll(), error);
    if (!made)
        return {};
    gl.glUseProgram(made);
    setDents(gl, made, dents);
    const std::vector<float> places = run(gl, mesh);
    std::vector<core::Vec3> result;
    for (std::size_t i = 0; i + 2 < places.size(); i += 3)
        result.emplace_back(core::Vec3(places[i], places[i + 1], places[i + 2]) * 1e-3);
    return result;
}

} // namespace chiron::scene3d
