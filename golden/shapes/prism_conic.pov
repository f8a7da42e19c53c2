// prism: conic sweep, pointed and truncated, in linear and bezier splines, and as a subtrahend.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

prism { conic_sweep linear_spline 0, 1, 5, <-0.8, -0.7>, <0.7, -0.8>, <0.9, 0.6>, <-0.6, 0.8>, <-0.8, -0.7>
  rotate 180 * x translate <-1.9, 0.6, 0> pigment { rgb <0.8, 0.3, 0.2> } }
prism { conic_sweep bezier_spline 0.4, 1.2, 8, <-0.9, 0>, <-0.7, 0.9>, <0.7, 0.8>, <0.8, 0.1>, <0.8, 0.1>, <0.6, -0.9>, <-0.5, -0.9>, <-0.9, 0>
  rotate 170 * x scale <1, 1.4, 1> translate <0, 1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
difference {
  box { <-0.8, 0, -0.8>, <0.8, 1, 0.8> }
  prism { conic_sweep linear_spline 0, 1.3, 4, <-0.6, -0.4>, <0.6, -0.4>, <0.1, 0.7>, <-0.6, -0.4> translate -0.1 * y pigment { rgb <0.9, 0.8, 0.3> } }
  rotate <-25, 20, 0>
  translate <1.9, -0.5, 0>
  pigment { rgb <0.3, 0.4, 0.9> }
}
