// Unusual numbers: cones of two halves, spindles, a sphere in disguise, box corners in any order.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

cone { <-2.2, 0.3, 0>, 0.6, <-2.2, 2, 0>, -0.5 pigment { rgb <0.8, 0.3, 0.2> } }
ovus { 0.4, 0.9 translate <2.1, 0.6, 0> scale 0.9 pigment { rgb <0.9, 0.8, 0.3> } }
superellipsoid { <1.8, 1.6> scale 0.9 rotate <20, 30, 0> translate <-2.1, -1, 0> pigment { rgb <0.8, 0.3, 0.2> } }
sphere_sweep { b_spline 5, <-0.9, -0.3, 0>, 0.3, <-0.3, 0.5, -0.4>, 0.25, <0.4, -0.5, 0.2>, 0.35, <0.9, 0.3, 0>, 0.2, <0.5, 0.6, 0.3>, 0.2
  tolerance 0.001 translate <-0.6, -1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
difference { sphere { 0, 0.7 } torus { 0.3, 0.4 sturm rotate 90 * x translate -0.6 * z } rotate 20 * y translate <0.9, -1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
box { <0.6, 0.5, 0.3>, <-0.5, -0.6, -0.4> rotate <20, 40, 10> translate <2.3, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
