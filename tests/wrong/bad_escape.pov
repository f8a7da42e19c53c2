// A backslash before a letter that means nothing.
#debug "C:\pictures\n"
