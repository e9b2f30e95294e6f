local holder = {x = 0}

function bench()
  local o = holder
  o.x = 0
  for i = 0, 999999 do o.x = o.x + 1 end
  return o.x
end
