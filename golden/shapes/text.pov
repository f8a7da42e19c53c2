// text: the four built-in fonts, thickness and offset.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -7> look_at 0 angle 42 }
light_source { <-5, 7, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
text { internal 1 "Tray" 0.3, 0 rotate <10, 20, 0> translate <-2.4, 0.7, 0> scale 1.1 pigment { rgb <0.8, 0.3, 0.2> } }
text { internal 2 "Aeg" 0.2, <0.1, 0.1, 0> translate <0.4, 0.7, 0> scale 1.1 pigment { rgb <0.3, 0.7, 0.3> } }
text { internal 3 "Box" 0.5, 0 rotate -20 * y translate <-2.2, -0.8, 0> pigment { rgb <0.3, 0.4, 0.9> } }
difference {
  box { <0, -0.2, 0>, <2, 0.9, 0.3> }
  text { internal 1 "AVo" 0.5, 0 translate <0.15, 0.1, -0.2> pigment { rgb <0.9, 0.8, 0.3> } }
  translate <0.4, -1.1, 0>
  pigment { rgb 0.7 }
}
