// Functions and macros of math.inc at many values.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "math.inc"
#macro Show(V) #debug concat("@", vstr(5, 0 + V, ", ", 0, 9), "\n") #end

#for (K, -7, 7)
  #declare T = K * 0.7;
  Show(<even(K), odd(K), sgn(T), f_sqr(T), even(T)>)
  Show(<sind(K * 37), cosd(K * 37), tand(K * 37), atand(T), atan2d(T, 2)>)
  Show(<asind(K / 7), acosd(K / 7), odd(T), max3(T, 1, K / 3), min3(T, 1, K / 3)>)
  Show(<clip(T, -1, 2), clamp(T, -1, 2), clamp(K, 0, 3), adj_range(T, 2, 5), adj_range2(T, -1, 1, 4, 8)>)
#end

Show(1 * Interpolate(0.3, 0, 1, 0, 10, 0))
Show(1 * Interpolate(0.3, 0, 1, 0, 10, 1))
Show(1 * Interpolate(0.3, -1, 1, 2, 10, 2))
Show(1 * Interpolate(0.3, -1, 1, 2, 10, 0.5))
Show(1 * Interpolate(0.3, 0, 1, 2, 10, -2))
Show(1 * Interpolate(0.7, 0, 1, 2, 10, -1))
Show(1 * Interpolate(0.7, 0, 1, 2, 10, -0.5))

#declare Values = array[8] { 3, 1, 4, 1, 5, 9, 2, 6 }
#declare M = Mean(Values);
Show(1 * M)
Show(1 * Std_Dev(Values, M))
GetStats(Values)
#for (K, 0, 4) Show(1 * StatisticsArray[K]) #end
// Histogram is not compared: the one that comes with POV-Ray 3.7.0.10 stops at an undeclared name.

#declare Points = array[6] { <1, 2, 3>, <-3, 0.5, 2>, <0, 0, 0>, <0.1, -5, 0.2>, <2, 2, -2>, <0, 1, 0> }
#declare Fives = array[3] { <1, 2, 3, 4, 5>, <0, 0, 0, 0, 0>, <0.5, -1, 2, 0.25, 3> }
#for (I, 0, 5)
  #declare A = Points[I];
  Show(1 * VSqr(A))
  Show(VPow(A * A, 1.5))
  Show(<VMin(A), VMax(A), VZero(A)>)
  #if (vlength(A) > 0)
    Show(1 * VWith_Len(A, 3))
    #declare P = VPerp_To_Vector(A);
    Show(<vdot(P, A), vlength(P)>)
    Show(1 * P)
  #end
  #for (J, 0, 5)
    #declare B = Points[J];
    Show(<VDist(A, B), VEq(A, B)>)
    #if (I != J & vlength(A) > 0 & vlength(B) > 0)
      Show(<VCos_Angle(A, B), VAngle(A, B), VAngleD(A, B)>)
      #declare N = vcross(A, B);
      Show(<VRotation(A, B, N), VRotation(A, B, -N), VRotationD(A, B, -N), VRotation(A, B, <0, 0, 0>)>)
      Show(1 * VPerp_To_Plane(A, B))
      Show(1 * VPerp_Adjust(A, B))
      Show(1 * VProject_Plane(A, B))
      Show(1 * VProject_Axis(A, B))
    #end
  #end
#end
#for (I, 0, 2)
  #declare A = Fives[I];
  Show(<VLength5D(A), VZero5D(A), VDot5D(A, Fives[0]), VEq5D(A, Fives[0])>)
  #if (I != 1) Show(1 * VNormalize5D(A)) #end
  Show(VPow5D(A * A, 0.7))
#end

#declare F = function { x * x * y + sin(z) }
#declare G = function { y * z - x }
#declare H = function { exp(x * 0.3) * y }
#declare L = fn_Gradient(F)
#declare D = fn_Gradient_Directional(F, <1, 2, -1>)
#declare V = fn_Divergence(F, G, H)
Show(<L(1, 2, 3), D(1, 2, 3), V(1, 2, 3)>)
Show(vGradient(F, <1, 2, 3>))
Show(vCurl(F, G, H, <1, 2, 3>))
Show(<Divergence(F, G, H, <1, 2, 3>), Gradient_Length(F, <1, 2, 3>), Gradient_Directional(F, <1, 2, 3>, <1, 2, -1>)>)
SetGradientAccuracy(0.1)
Show(vGradient(F, <1, 2, 3>))
Show(1 * __Gradient_Fn_Accuracy_)
