local Board = {}
Board.__index = Board

local function all_true(n)
  local list = {}
  for i = 0, n do list[i] = true end
  return list
end

function Board.new(n)
  return setmetatable({
    n = n, rows = all_true(n), up = all_true(2 * n), down = all_true(2 * n), found = 0
  }, Board)
end

function Board:place(column)
  if column == self.n then
    self.found = self.found + 1
  else
    for row = 0, self.n - 1 do
      if self.rows[row] and self.up[column + row] and self.down[column - row + self.n] then
        self:set(row, column, false)
        self:place(column + 1)
        self:set(row, column, true)
      end
    end
  end
end

function Board:set(row, column, free)
  self.rows[row] = free
  self.up[column + row] = free
  self.down[column - row + self.n] = free
end

function bench()
  local board = Board.new(7)
  board:place(0)
  return board.found
end
