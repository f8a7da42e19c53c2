// CSG of unlike shapes: lathe, blob, text and prism cut each other.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

intersection {
  lathe { linear_spline 5, <0.1, -1>, <1, -0.9>, <0.9, 0.8>, <0.1, 1>, <0.1, -1> }
  blob { threshold 0.4 sphere { 0, 1.8, 1 } sphere { <0.8, 0.6, -0.5>, 0.8, -1 } }
  pigment { rgb <0.8, 0.5, 0.2> }
  translate -1.5 * x
}
difference {
  prism { linear_spline -0.8, 0.8, 6, <-1, -0.6>, <0, -0.9>, <1, -0.6>, <0.9, 0.7>, <-0.9, 0.7>, <-1, -0.6> }
  text { internal 1 "R" 1, 0 scale 1.6 translate <-0.6, -0.5, -1.3> pigment { rgb <0.9, 0.8, 0.3> } }
  superellipsoid { <0.4, 0.4> scale 0.5 translate <0.8, 0.8, -0.5> pigment { rgb <0.3, 0.7, 0.3> } }
  rotate <-15, 15, 0>
  translate 1.5 * x
  pigment { rgb <0.3, 0.4, 0.9> }
}
