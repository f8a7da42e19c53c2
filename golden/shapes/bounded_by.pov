// bounded_by: a bound that holds the object changes nothing; an object inside a bounded union.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

union {
  sphere { -x, 0.6 } torus { 0.6, 0.2 translate x } box { -0.3, 0.3 rotate 45 * y }
  bounded_by { box { <-2, -1, -1>, <2, 1, 1> } }
  rotate <25, 20, 0>
  pigment { rgb <0.8, 0.5, 0.2> }
}
