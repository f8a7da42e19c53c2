// Outside a picture that is shown once, metallic highlights and reflections are tinted by white; conserve_energy does nothing.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.8, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
#declare Once = pigment { image_map { function 6, 6 { x * y + 0.2 } once } translate <-0.5, -0.5, 0> }
sphere { -1.3 * x, 0.9 texture { pigment { Once translate -1.3 * x } finish { phong 0.8 phong_size 8 metallic } } }
sphere { 1.3 * x, 0.9 texture { pigment { Once translate 1.3 * x } finish { reflection { 0.4 metallic 0.7 } conserve_energy } } }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.7, 0.2, 0.1> scale 0.8 } }
