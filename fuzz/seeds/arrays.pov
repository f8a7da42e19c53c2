#declare A = array[2][3] { { 1, 2, 3 }, { 4, 5, 6, } }
#declare B = array[2] { "one", "two" }
#declare C = array[2];
#declare C[0] = A;
#declare C[1] = A;
#declare D = C[1][0][2] + dimensions(A) + dimension_size(A, 2);
#undef A[0][1]
#declare O = array[1] { sphere { 0, 1 pigment { rgb <1, 0.5, 0> } } }
object { O[0] translate A[1][2] * y }
#debug concat(B[0], substr(B[1], 1, 2), strupr("abc"), chr(65), str(val("2.5"), 5, 2), str(asc("a"), -6, 1))
