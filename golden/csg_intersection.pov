// intersection: a lens, and a die cut from planes and a sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

intersection {
  sphere { -0.8 * z, 1.2 pigment { rgb <0.8, 0.3, 0.2> } }
  sphere { 0.8 * z, 1.2 pigment { rgb <0.9, 0.8, 0.3> } }
  rotate 60 * y
  translate -1.3 * x
}
intersection {
  plane { x, 0.7 } plane { -x, 0.7 } plane { y, 0.7 } plane { -y, 0.7 } plane { z, 0.7 } plane { -z, 0.7 }
  sphere { 0, 0.95 pigment { rgb <0.3, 0.4, 0.9> } }
  rotate <20, 30, 0>
  translate 1.2 * x
  pigment { rgb <0.3, 0.7, 0.3> }
}
