// The albedo of the skin. With OWN_COLOURS that of the model itself: its picture under the tint of
// material and corners, and the look's where it has none.
#include "render_bindings.h"
#include "skin.glsl"

#ifdef OWN_COLOURS
in vec2 skinUv;  // v runs upwards
in vec4 skinTint;  // w: 1 for a colour of the model, 0 for that of the look

layout(binding = kUnitSkin) uniform sampler2D skinPicture;
uniform float hasSkinPicture;

vec3 skinColour(vec3 rest) {
    vec3 own = skinTint.rgb;
    if (hasSkinPicture > 0.0) {
        own *= texture(skinPicture, vec2(skinUv.x, 1.0 - skinUv.y)).rgb;
    }
    return mix(skinColor, own, skinTint.w);
}
#else
vec3 skinColour(vec3 rest) { return skinAlbedo(rest); }
#endif
