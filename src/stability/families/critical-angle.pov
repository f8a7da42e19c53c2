//! about: total reflection in glass at the critical angle, in a field of view 10^X wide
//! extremity: 10^X
//! steps: -2 -4 -6 -8 -10 -11 -12 -13
//! note: at 10^-14 neighbouring pixels would have the same directions.
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
// The camera stands in the glass; what is mirrored is red, what comes through is blue.
#declare Sine = 1 / 1.5;
#declare Critical = <Sine, 0, sqrt(1 - Sine * Sine)>;
camera { location -5*z direction Critical right y * pow(10, X) up <Critical.z, 0, -Critical.x> * pow(10, X) }
box { <-1e3, -1e3, -20>, <1e3, 1e3, 0> hollow pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
plane { z, -10 pigment { rgb <1, 0, 0> } finish { ambient 1 diffuse 0 } }
background { rgb <0, 0, 1> }
