package org.urbi.web;

import io.netty.channel.WriteBufferWaterMark;

/**
 * A page that is served, and the limits of those who look at it.
 *
 * @param home the class beside which its files are, and in folders there; {@code index.html} is one
 *     of them. Beside them each page has the folder {@code shared}, with the stream. Files whose
 *     names do not end like those of pages are not served.
 * @param longestMessage of a browser on the stream, in bytes; a longer one ends its connection
 * @param silence after how many seconds of hearing nothing a connection ends; one with a stream is
 *     asked first whether it is still there
 * @param backlog what of a browser has not been sent yet, in bytes: beyond it, its channel is not
 *     writable
 */
public record Page(Class<?> home, int longestMessage, int silence, WriteBufferWaterMark backlog) {}
