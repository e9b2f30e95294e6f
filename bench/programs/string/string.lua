function bench()
  local text = ""
  for i = 0, 9999 do text = text .. "x" end
  return #text
end
