// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import { Film } from './film';
import type { Document } from './model';

const text = document.getElementById('fairway-data')?.textContent?.trim() ?? '';
const playback = JSON.parse(text) as Document;
const film = new Film(playback.columns, playback.scene.vehicles.length);
if (playback.film !== null) film.append(playback.film);
document.getElementById('page')!.textContent = `${playback.title}: ${film.count} frames`;
