local function make_list(length)
  if length == 0 then
    return nil
  else
    return {next = make_list(length - 1)}
  end
end

local function is_shorter(x, y)
  local a = x
  local b = y
  while b do
    if not a then return true end
    a = a.next
    b = b.next
  end
  return false
end

local function tail(x, y, z)
  if is_shorter(y, x) then
    return tail(tail(x.next, y, z), tail(y.next, z, x), tail(z.next, x, y))
  else
    return z
  end
end

local function length(list)
  if not list then
    return 0
  else
    return 1 + length(list.next)
  end
end

function bench()
  return length(tail(make_list(12), make_list(9), make_list(5)))
end
