// Takes a message of each of some topics by Foxglove's own client: node look-ros.cjs ADDRESS SUBPROTOCOL TOPIC…, with
// NODE_PATH. Each line has a topic, and in base 64 the name of its type, the type itself, and the message.
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

const [address, subprotocol, ...wanted] = process.argv.slice(2);
const client = new FoxgloveClient({ ws: new WebSocket(address, [subprotocol]) });
const channels = new Map();
const coded = (bytes) => Buffer.from(bytes).toString("base64");

client.on("error", (error) => console.log("error", String(error)));
client.on("close", () => process.exit(0));
client.on("advertise", (all) => {
  for (const channel of all) {
    const fits = channel.encoding === "cdr" && channel.schemaEncoding === "ros2msg";
    if (fits && wanted.includes(channel.topic)) channels.set(client.subscribe(channel.id), channel);
  }
});
client.on("message", ({ subscriptionId, data }) => {
  const { topic, schemaName, schema } = channels.get(subscriptionId);
  if (!wanted.includes(topic)) return;
  wanted.splice(wanted.indexOf(topic), 1);
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  console.log(topic, coded(schemaName), coded(schema), coded(bytes));
  if (!wanted.length) client.close();
});
