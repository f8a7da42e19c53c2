// rainbow: arc, falloff, and the colours of a map with transmit.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at <0, 1.2, 0> angle 60 }
light_source { <-50, 70, -60> rgb 1 }
plane { y, 0 pigment { rgb <0.4, 0.5, 0.3> } }
#for (K, 0, 5)
  cone { <1.5 * K - 2.5, 0, 3 * K>, 0.6, <1.5 * K - 2.5, 2.5, 3 * K>, 0 pigment { rgb <0.7, 0.3, 0.2> } }
#end
sphere { <-2.5, 0.6, -2>, 0.6 pigment { rgb 0.1 } finish { reflection 0.7 } }

rainbow {
  angle 30 width 9 distance 40 direction <0.1, -0.1, 1> arc_angle 150 falloff_angle 100
  color_map { [0 rgbt <1, 0.2, 0.9, 0.9>] [0.3 rgbt <0.2, 0.3, 1, 0.6>] [0.6 rgbt <0.2, 1, 0.3, 0.6>] [0.9 rgbt <1, 0.2, 0.1, 0.6>] [1 rgbt <1, 0, 0, 1>] }
}
