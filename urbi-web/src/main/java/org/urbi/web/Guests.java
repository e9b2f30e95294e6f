package org.urbi.web;

import io.netty.channel.ChannelHandler;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Programs that want no page, only a stream of a protocol of their own, by which they are known.
 *
 * @param subprotocols the names of that protocol, the best one first
 * @param origins sites whose pages may be such a program, as {@code https://example.org}; those of
 *     others are refused
 * @param longestMessage of a program, in bytes; a longer one ends its connection
 * @param handler makes what handles the WebSocket frames of one
 */
public record Guests(
    List<String> subprotocols,
    Set<String> origins,
    int longestMessage,
    Supplier<ChannelHandler> handler) {
  /** Whether one of the subprotocols that a client offers, separated by commas, is theirs. */
  boolean speak(String offered) {
    return Arrays.stream(offered.split(",")).map(String::strip).anyMatch(subprotocols::contains);
  }
}
