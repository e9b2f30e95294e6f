local Towers = {}
Towers.__index = Towers

function Towers:push(disc, pile)
  local top = self.piles[pile]
  if top and disc.size >= top.size then error("a disc on a smaller one") end
  disc.next = top
  self.piles[pile] = disc
end

function Towers:pop(pile)
  local top = self.piles[pile]
  self.piles[pile] = top.next
  top.next = nil
  return top
end

function Towers:move(n, from, to)
  if n == 1 then
    self:push(self:pop(from), to)
    self.moves = self.moves + 1
  else
    local other = 3 - from - to
    self:move(n - 1, from, other)
    self:move(1, from, to)
    self:move(n - 1, other, to)
  end
end

function bench()
  local towers = setmetatable({piles = {}, moves = 0}, Towers)
  for size = 12, 1, -1 do towers:push({size = size}, 0) end
  towers:move(12, 0, 2)
  return towers.moves
end
