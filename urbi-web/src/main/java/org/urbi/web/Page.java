package org.urbi.web;

import io.netty.channel.WriteBufferWaterMark;

/**
 * A page that is served, and the limits of those who look at it.
 *
 * @param home the class beside which its files are, and in folders there; {@code index.html} is one
 *     of them. What is no file of a page by the end of its name is not served.
 * @param longestMessage of a browser on the stream, in bytes; a longer one ends its connection
 * @param silence after how many seconds of hearing nothing a connection that is no stream ends; one
 *     that is is asked first whether it is still there
 * @param backlog what of a browser has not been sent yet, in bytes: beyond it, its channel is not
 *     writable
 */
public record Page(Class<?> home, int longestMessage, int silence, WriteBufferWaterMark backlog) {}
