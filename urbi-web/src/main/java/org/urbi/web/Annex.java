package org.urbi.web;

import io.netty.channel.ChannelHandler;
import java.util.function.Function;

/**
 * A page of a component, which other pages of the same process can show as a part of theirs.
 *
 * @param title for people
 * @param page its files, and the limits of those who look at it
 * @param viewer makes what handles the WebSocket frames of a browser that has been let in; it is
 *     given why that browser can only look, or an empty text if it may intervene
 */
public record Annex(String title, Page page, Function<String, ChannelHandler> viewer) {}
