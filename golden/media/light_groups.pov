// The object behind decides which lights reach a medium: the left wall is lit by its group's own light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 40 }
light_source { <4, 4, -4> rgb <0.3, 0.8, 0.4> }
#declare Air = interior { media { scattering { 1, 0.25 } samples 6 intervals 2 } }
light_group {
  light_source { <-3, 2, -2> rgb <1.2, 0.4, 0.2> }
  box { <-3, -2, 1.6>, <0, 2, 1.8> pigment { rgb 0.7 } }
}
light_group {
  light_source { <2, -2, -2> rgb <0.2, 0.3, 1> media_interaction off }
  box { <0, -2, 1.6>, <3, 2, 1.8> pigment { rgb 0.7 } }
  global_lights on
}
box { <-1.8, -1.4, -0.6>, <1.8, 1.4, 0.6> hollow pigment { rgbt 1 } interior { Air } }
