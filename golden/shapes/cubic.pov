// cubic: a folded surface with 20 coefficients, in a box, beside a monkey saddle.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

intersection {
  cubic { <1, 0, 0, -0.2, 0, 0.3, 0, 0, 0, -0.6, 0.5, 0, 0, 0, 0, -1, 0, 0.4, 0, 0.1> }
  box { -1.1, 1.1 }
  rotate 30 * y
  translate -1.5 * x
  pigment { rgb <0.8, 0.5, 0.2> }
}
intersection {
  cubic { <1, 0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0> }
  sphere { 0, 1.1 }
  rotate <30, 20, 0>
  translate 1.5 * x
  pigment { rgb <0.3, 0.6, 0.8> }
}
