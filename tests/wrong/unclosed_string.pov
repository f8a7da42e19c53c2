// A string without its closing quote.
#debug "hello
sphere { 0, 1 }
