local Tree = {}
Tree.__index = Tree
function Tree.new(left, right) return setmetatable({left = left, right = right}, Tree) end
function Tree:check()
  if not self.left then
    return 1
  else
    return 1 + self.left:check() + self.right:check()
  end
end

local function make_tree(depth)
  if depth == 0 then
    return Tree.new(nil, nil)
  else
    return Tree.new(make_tree(depth - 1), make_tree(depth - 1))
  end
end

function bench()
  local sum = 0
  for i = 1, 10 do sum = sum + make_tree(9):check() end
  return sum
end
