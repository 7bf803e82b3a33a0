// The light of the endoscope's own lamp at a point and the sharpness of its camera there, computed per
// vertex. Only the picture of the wall and the wet highlight remain to be computed per pixel. Inserted into
// the vertex shaders of the linings.
uniform vec4 lamp;       // xyz: mm, camera; w: gain, mm²
uniform vec2 sharpness;  // x: 1/focus (1/mm), y: strength of the blur (mm): see ThinLens, over its largest circle
uniform float rough;     // roughness of the slopes

out vec3 normal;
out vec3 across;
out vec3 along;
out vec3 toLamp;
out vec3 halfway;
out vec3 reach; // x: the light that arrives, y: the light that leaves beside where it entered, z: 1 = sharp

void lightUp(vec3 eye, vec3 outward, vec3 way)
{
    normal = outward;
    vec3 flatWay = normalize(way - outward * dot(outward, way));
    across = rough * cross(flatWay, outward);
    along = rough * flatWay;
    toLamp = lamp.xyz - eye;
    float far2 = dot(toLamp, toLamp);
    toLamp *= inversesqrt(far2);
    halfway = normalize(toLamp - eye * inversesqrt(dot(eye, eye)));
    reach.x = lamp.w / (far2 + 14.0);
    reach.y = reach.x * max(0.0, 0.6 * dot(outward, toLamp) + 0.4);
    reach.z = 1.0 - min(1.0, sharpness.y * abs(sharpness.x + 1.0 / min(-0.3, eye.z)));
}
