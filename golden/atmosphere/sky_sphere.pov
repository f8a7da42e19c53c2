// sky_sphere: two pigments, the upper one with holes, transforms, and mirrored in a ball.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at <0, 1.2, 0> angle 60 }
light_source { <-50, 70, -60> rgb 1 }
plane { y, 0 pigment { rgb <0.4, 0.5, 0.3> } }
#for (K, 0, 5)
  cone { <1.5 * K - 2.5, 0, 3 * K>, 0.6, <1.5 * K - 2.5, 2.5, 3 * K>, 0 pigment { rgb <0.7, 0.3, 0.2> } }
#end
sphere { <-2.5, 0.6, -2>, 0.6 pigment { rgb 0.1 } finish { reflection 0.7 } }

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [0.4 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.2, 0.6>] } }
  pigment { bozo turbulence 0.6 color_map { [0 rgbt <1, 1, 1, 1>] [0.5 rgbt <1, 1, 1, 1>] [0.7 rgbt <1, 1, 1, 0.1>] [1 rgbt <0.8, 0.8, 0.8, 0>] } scale <0.4, 0.15, 0.4> }
  rotate 20 * z
}
