/**
 * What Foxglove, and programs like it, are sent: variables as channels of messages, by its
 * WebSocket protocol (docs/recording.md).
 */
@NullMarked
package org.urbi.server.studio.foxglove;

import org.jspecify.annotations.NullMarked;
