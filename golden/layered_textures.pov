// layered textures: stripes over checks over paint, and a layer with a highlight of its own.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.8, -6> look_at 0 angle 38 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }

sphere {
  <-1.2, 0, 0>, 1.1
  texture { pigment { rgb <0.8, 0.3, 0.2> } }
  texture { pigment { checker rgbt <0, 0, 0, 1> rgbt <0.9, 0.9, 0.9, 0.3> scale 0.5 } }
  texture { pigment { gradient y color_map { [0 rgbf 1] [0.6 rgbf 1] [0.6 rgbf <0.1, 0.2, 0.7, 0.3>] [1 rgbf <0.1, 0.2, 0.7, 0.9>] } scale 0.6 } finish { phong 0.8 } }
}
box {
  -0.8, 0.8
  texture { pigment { rgb <0.9, 0.8, 0.3> } finish { diffuse 0.8 } }
  texture { pigment { rgbft <0.2, 0.6, 0.3, 0.4, 0.3> } finish { specular 0.6 reflection 0.2 } }
  rotate <20, 35, 0>
  translate 1.3 * x
}
