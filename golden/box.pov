// box: corners in any order, turned, and one around the camera.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 45 }
light_source { <-3, 4, -5> rgb 1 }

box { <-0.5, -1, -0.6>, <0.6, 0.7, 0.5> rotate 30 * y translate -1.5 * x pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.6, 0.7, 0.5>, <-0.7, -0.4, -0.5> rotate <30, 40, 10> translate 1.4 * x pigment { rgb <0.3, 0.7, 0.3> } }
box { <-9, -1.2, -9>, <9, 7, 9> pigment { checker rgb 0.6 rgb 0.9 } }
