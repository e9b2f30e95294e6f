local Task = {}
Task.__index = Task

local function make(class, task)
  task.runs = 0
  return setmetatable(task, class)
end

local function extend(base)
  local class = setmetatable({}, {__index = base})
  class.__index = class
  return class
end

function Task:put(packet)
  packet.next = nil
  if not self.first then
    self.first = packet
  else
    self.last.next = packet
  end
  self.last = packet
end

function Task:take()
  local packet = self.first
  self.first = packet.next
  return packet
end

function Task:is_ready() return self.first ~= nil end

local Source = extend(Task)
function Source:is_ready() return self.left > 0 end
function Source:run()
  self.left = self.left - 1
  local kind = self.left % 3 == 0 and "disc" or "line"
  self.system:send("worker", {kind = kind, datum = self.left})
end

local Worker = extend(Task)
function Worker:run()
  local packet = self:take()
  packet.datum = (packet.datum * 7 + 13) % 1009
  self.system:send(packet.kind, packet)
end

local Device = extend(Task)
function Device:run()
  local packet = self:take()
  self.sum = (self.sum + packet.datum) % 65521
end

local System = {}
System.__index = System
function System.new(packets)
  local system = setmetatable({names = {"disc", "line", "worker", "source"}}, System)
  system.tasks = {
    make(Device, {system = system, priority = 4, sum = 0}),
    make(Device, {system = system, priority = 3, sum = 0}),
    make(Worker, {system = system, priority = 2}),
    make(Source, {system = system, priority = 1, left = packets})
  }
  return system
end

function System:send(name, packet)
  for i = 1, #self.names do
    if self.names[i] == name then
      self.tasks[i]:put(packet)
      return
    end
  end
  error("no such task: " .. name)
end

function System:next()
  local best = nil
  for _, task in ipairs(self.tasks) do
    if task:is_ready() and (not best or task.priority > best.priority) then best = task end
  end
  return best
end

function System:schedule()
  local task = self:next()
  while task do
    task.runs = task.runs + 1
    task:run()
    task = self:next()
  end
end

function bench()
  local system = System.new(500)
  system:schedule()
  local sum = 0
  for _, task in ipairs(system.tasks) do sum = sum * 7 + task.runs end
  return sum + system.tasks[1].sum + system.tasks[2].sum
end
