package org.urbi.web;

import io.netty.channel.ChannelHandler;
import java.util.function.Function;

/**
 * How browsers come from a page to its {@linkplain Annexes annexes}: the files and the stream of
 * each are below {@code /annex/COMPONENT/} on the port of the page.
 *
 * @param gate makes what lets a browser in to the stream of an annex, and then gives way to the
 *     viewer of that annex
 */
public record Entrance(Annexes annexes, Function<Annex, ChannelHandler> gate) {}
