/**
 * How values of variables are told to Foxglove and programs like it, live and in files: as JSON, or
 * as messages of ROS 2 (docs/recording.md).
 */
@NullMarked
package org.urbi.server.studio.messages;

import org.jspecify.annotations.NullMarked;
